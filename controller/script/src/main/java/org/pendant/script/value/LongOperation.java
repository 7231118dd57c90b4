package org.pendant.script.value;

/**
 * Long operation: computed piece by piece, each of which takes a fraction of a frame, so that large
 * values delay no other thread. Values it works on must not change until it is done: code that
 * stops between two pieces calls {@link #keep} first.
 */
public interface LongOperation {
  /** How many elements, or products of two, a piece has at most. */
  int PIECE = 1 << 17;

  /**
   * Computes the next piece.
   *
   * @return how many elements it had, or how many it would have had that take as long
   * @throws ScriptError when the elements cannot be combined
   */
  int advance() throws ScriptError;

  /** Whether all pieces are computed. */
  boolean done();

  /** What came out; only when it is done. */
  Value result() throws ScriptError;

  /** Has what it works on copied before it is changed. */
  void keep();

  /** What it works on and has made so far, see {@link Value#sizeBytes}. */
  long sizeBytes();

  /** Computes all pieces at once. */
  static Value finish(LongOperation operation) throws ScriptError {
    while (!operation.done()) {
      operation.advance();
    }
    return operation.result();
  }
}
