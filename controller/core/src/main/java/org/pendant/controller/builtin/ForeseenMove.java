package org.pendant.controller.builtin;

import org.pendant.motion.Move;
import org.pendant.script.function.Foreseen;

/**
 * A move that a program will ask for.
 *
 * @param move the move
 */
record ForeseenMove(Move move) implements Foreseen {
  @Override
  public boolean last() {
    return move.blendRadiusM() == 0;
  }
}
