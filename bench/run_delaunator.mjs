// delaunator (npm) for bench/compare: `delaunay` of INPUT.points, called as measure.hpp says.
import {readFileSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';

const require = createRequire(import.meta.url);  // unlike import it looks in NODE_PATH, too
const {default: Delaunator} = await import(require.resolve('delaunator/index.js'));
const {version} = require('delaunator/package.json');

const [task, input, result] = process.argv.slice(2);
if (task !== 'delaunay') throw new Error(`no task is called ${task}`);

const file = readFileSync(`${input}.points`);
const coordinates = new Float64Array(file.buffer, file.byteOffset, file.length / 8);

function bytes(name) {
  return 1024 * Number(new RegExp(`^${name}:\\s*(\\d+)`, 'm').exec(readFileSync('/proc/self/status'))[1]);
}

const seconds = [];
function timed() {
  const start = process.hrtime.bigint();
  const mesh = new Delaunator(coordinates);
  seconds.push(Number(process.hrtime.bigint() - start) / 1e9);
  return mesh;
}

writeFileSync('/proc/self/clear_refs', '5');
const before = bytes('VmRSS');
const mesh = timed();
const peak = bytes('VmHWM');
for (let sum = seconds[0]; sum < 0.2; sum += seconds.at(-1)) timed();

if (result) {
  writeFileSync(`${result}.points`, new Uint8Array(coordinates.buffer, coordinates.byteOffset, coordinates.byteLength));
  const corners = Float64Array.from(mesh.triangles);
  for (let t = 0; t < corners.length; t += 3) {  // clockwise
    [corners[t + 1], corners[t + 2]] = [corners[t + 2], corners[t + 1]];
  }
  writeFileSync(`${result}.triangles`, new Uint8Array(corners.buffer));
}
seconds.sort((a, b) => a - b);
console.log(JSON.stringify({
  seconds: seconds[seconds.length >> 1], bytes: Math.max(0, peak - before), triangles: mesh.triangles.length / 3,
  version,
}));
