package org.pendant.controller.box;

import static org.pendant.controller.box.BoxTexts.text;

import java.time.Instant;
import java.time.InstantSource;
import java.util.Optional;
import org.pendant.models.time.FrameTime;

/** Clock of a control box: counts its frames; its date follows them or the wall clock. */
public final class BoxClock {
  /** The date at which a box in virtual time is switched on. */
  public static final Instant VIRTUAL_START = Instant.parse("2026-01-01T00:00:00Z");

  private static final long FRAME_NS = 1_000_000_000L / FrameTime.FRAMES_PER_SECOND;

  private final Optional<InstantSource> wall;
  private final ExecutionTime executionTime;
  private final Determinism determinism = new Determinism(this);
  private long frame;
  private double behindS;
  private double nextToldS;

  /**
   * A clock whose date comes from {@code wall}, or without one from the frames.
   *
   * @param executionTime how long frames take in virtual time
   */
  BoxClock(Optional<InstantSource> wall, ExecutionTime executionTime) {
    this.wall = wall;
    this.executionTime = executionTime;
  }

  void beginFrame() {
    frame++;
    executionTime.beginFrame();
  }

  /** Number of the frame that is running, from 1; 0 before the first. */
  public long frame() {
    return frame;
  }

  /** Controller time at the end of the running frame, s since the box was switched on. */
  public double timeS() {
    return frame / (double) FrameTime.FRAMES_PER_SECOND;
  }

  /** Controller time as {@link #timeS}, ns. */
  public long timeNs() {
    return frame * FRAME_NS;
  }

  /** The date and time of day; that of the wall cannot be repeated. */
  public Instant systemTime() {
    determinism.loseInRealTime(text("askedForDate"));
    return wall.isPresent() ? wall.get().instant() : VIRTUAL_START.plusNanos(timeNs());
  }

  /** How long the running frame is taken to need in virtual time, s. */
  public double executionTimeS(boolean programRuns) {
    return executionTime.seconds(programRuns);
  }

  /** By how much robot time has fallen behind the wall clock, s; 0 in virtual time. */
  public double behindS() {
    return behindS;
  }

  /**
   * Robot time has fallen behind the wall clock.
   *
   * @param behindS by how much since the box was switched on, s
   * @return whether that is worth a word: at first, and when it has doubled or grown by a second
   */
  public boolean fellBehind(double behindS) {
    this.behindS = behindS;
    boolean told = behindS >= nextToldS;
    if (told) {
      nextToldS = Math.max(2 * behindS, behindS + 1);
    }
    return told;
  }

  /** Whether the frames up to now can run once more with the same outcome. */
  public Determinism determinism() {
    return determinism;
  }

  /** Whether the clock of the wall drives the frames, so that a run cannot be repeated exactly. */
  public boolean inRealTime() {
    return wall.isPresent();
  }
}
