package org.pendant.motion.toolpath;

import java.util.List;
import org.pendant.motion.ToolCurve;

/** Chain of segments, each continuing where and in the direction in which the last one ends. */
final class Chain implements ToolCurve {
  private final List<Piece> pieces;

  /** Where each piece begins, and where the last one ends. */
  private final double[] begins;

  private int current;

  /**
   * A part of the chain.
   *
   * @param curve of which it is a part
   * @param from where on it the part begins
   * @param length of the part, above 0
   * @param speed how fast it may be passed, per s
   * @param acceleration how fast the speed may change on it, per s²
   * @param stops whether the tool has to rest at its end
   * @param name of the motion that it belongs to, for messages
   */
  record Piece(
      ToolCurve curve,
      double from,
      double length,
      double speed,
      double acceleration,
      boolean stops,
      String name) {}

  Chain(List<Piece> pieces) {
    this.pieces = List.copyOf(pieces);
    begins = new double[pieces.size() + 1];
    for (int i = 0; i < pieces.size(); i++) {
      begins[i + 1] = begins[i] + pieces.get(i).length();
    }
  }

  List<Piece> pieces() {
    return pieces;
  }

  double length() {
    return begins[pieces.size()];
  }

  /** Where a piece begins. */
  double begin(int piece) {
    return begins[piece];
  }

  /** The name of the motion at a point. */
  String name(double at) {
    return pieces.get(find(at)).name();
  }

  /** The piece at a point, looked for from the last one on. */
  private int find(double at) {
    while (current + 1 < pieces.size() && at >= begins[current + 1]) {
      current++;
    }
    while (current > 0 && at < begins[current]) {
      current--;
    }
    return current;
  }

  private double within(Piece piece, double at) {
    return piece.from() + Math.max(0, Math.min(piece.length(), at - begins[current]));
  }

  @Override
  public void at(double at, double[] transform) {
    Piece piece = pieces.get(find(at));
    piece.curve().at(within(piece, at), transform);
  }

  @Override
  public void rate(double at, double[] twist) {
    Piece piece = pieces.get(find(at));
    piece.curve().rate(within(piece, at), twist);
  }

  @Override
  public void bend(double at, double[] twist) {
    Piece piece = pieces.get(find(at));
    piece.curve().bend(within(piece, at), twist);
  }
}
