// Strips vertex by vertex: the cheapest ways from one triangle to the next. Cost: constant each.
//
// From the state (u, v), the edge of the last two vertices, sending
//
//     v, y           leads to (v, y) as even or odd as before: a strip that begins where one ended
//     v, v, y        to the same, turned: even becomes odd
//     v, x, v        to (x, v), turned
//     u, u, y        to (u, y), turned
//     v, x, x, y     to any (x, y); one v more turns it
//     restart, x, y  to any (x, y), even; one x more makes it odd
#include "strips/strip_writer.hpp"

namespace quadloom::strips {
namespace {

template <class... Vertices>
Bridge send_all(Vertices... v) {
  return {{v...}, sizeof...(v)};
}

Bridge first_edge(StripState to) {
  return to.odd ? send_all(to.before, to.before, to.last) : send_all(to.before, to.last);
}

Bridge restart(StripState to) {
  return to.odd ? send_all(kStripRestart, to.before, to.before, to.last)
                : send_all(kStripRestart, to.before, to.last);
}

Bridge without_restart(StripState from, StripState to) {
  const auto [u, v, odd] = from;
  const auto [x, y, to_odd] = to;
  if (from == to) return {};
  if (odd == to_odd) return x == v ? send_all(v, y) : send_all(v, x, x, y);
  if (x == v) return y == u ? send_all(u) : send_all(v, v, y);
  if (y == v) return send_all(v, x, v);
  if (x == u) return send_all(u, u, y);
  return send_all(v, v, x, x, y);
}

}  // namespace

Bridge bridge(StripState from, StripState to, StripEncoding encoding) {
  if (from.last == kNone) return first_edge(to);
  const Bridge straight = without_restart(from, to);
  if (encoding != StripEncoding::kRestart) return straight;
  const Bridge restarted = restart(to);
  return restarted.size < straight.size ? restarted : straight;
}

StripWriter::StripWriter(StripEncoding encoding, std::size_t triangles) {
  code_.encoding = encoding;
  code_.index.reserve(triangles + triangles / 2);
  if (encoding == StripEncoding::kSwap) code_.swap.reserve(triangles + triangles / 2);
}

void StripWriter::send(VertexId v) {
  code_.index.push_back(v);
  restarts_ += v == kStripRestart;
  if (code_.encoding == StripEncoding::kSwap) code_.swap.push_back(swap_next_);
  swap_next_ = false;
}

void StripWriter::go_to(StripState to) {
  if (code_.encoding == StripEncoding::kSwap) {
    if (state_.last != kNone) send(kStripRestart);
    send(to.odd ? to.last : to.before);
    send(to.odd ? to.before : to.last);
    swap_next_ = to.odd;
  } else {
    const Bridge way = bridge(state_, to, code_.encoding);
    for (const VertexId v : way.span()) send(v);
  }
  state_ = to;
}

void StripWriter::draw(VertexId apex) {
  corner_ = state_.before;
  send(apex);
  state_ = {state_.last, apex, !state_.odd};
}

//      apex              the state is (u, apex), but the path goes on over (corner, apex): u and
//      /  \\             corner change places before the apex is sent
//     /____\\            .
//  corner   u
void StripWriter::swap() {
  ++swaps_;
  if (code_.encoding == StripEncoding::kSwap) {
    code_.swap.back() ^= 1;
  } else {
    code_.index.back() = corner_;
    code_.index.push_back(state_.last);
  }
  state_ = {std::exchange(corner_, state_.before), state_.last, !state_.odd};
}

}  // namespace quadloom::strips
