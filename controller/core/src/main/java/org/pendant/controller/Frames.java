package org.pendant.controller;

/** Frames: lets robot time pass for one controller or a cell of them; used by one thread alone. */
public interface Frames {
  /** Runs one frame in the calling thread; a frame that a debugger pauses in continues. */
  void advance();

  /**
   * As {@link #advance}, but commands that have arrived are left for the next frame: they have come
   * later than this one.
   */
  void advanceBeforeCommands();

  /**
   * Carries out the commands that have arrived, without a frame: robot time stands, and the newest
   * snapshot shows what they have done.
   */
  void applyCommands();

  /**
   * Whether a script thread waits for a peer outside, which lives by the wall clock, or Modbus
   * devices are asked again and again.
   */
  boolean waitsForOutside();

  /**
   * Whether it is all the same when the next frames are run, as long as it is soon: no program
   * runs, nothing moves, and nobody follows frame by frame or waits outside.
   */
  boolean needsNoFrameOnTime();

  /** Whether somebody follows frame by frame. */
  boolean followed();

  /** Whether a debugger has paused a program in the middle of the frame. */
  boolean held();

  /**
   * Has {@code wake} run whenever a command has arrived, or somebody has begun to follow frame by
   * frame, by the thread that brought it; it must be short.
   */
  void wakeBy(Runnable wake);

  /**
   * Says that robot time has fallen behind the wall.
   *
   * @param sinceStartS by how much since the start, s
   */
  void noteLostTime(double sinceStartS);
}
