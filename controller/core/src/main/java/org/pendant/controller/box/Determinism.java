package org.pendant.controller.box;

import static org.pendant.controller.box.BoxTexts.text;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;

/**
 * Determinism of the run: whether it can be repeated with the same outcome. It can until something
 * enters that is neither an option nor a command: an answer of another computer, the date, the
 * speed of this computer. The frame loop writes it, any thread may read it.
 */
public final class Determinism {
  /** Files that are remembered; a run that reads more cannot be repeated from there on. */
  private static final int MAX_FILES = 1000;

  private final BoxClock clock;
  private final List<FileRead> files = new CopyOnWriteArrayList<>();
  private volatile Optional<Loss> loss = Optional.empty();

  /**
   * Why it is lost.
   *
   * @param frame the first that may come out otherwise when it runs once more
   * @param reason what came into it, as a sentence without its full stop
   */
  public record Loss(long frame, String reason) {}

  /**
   * A file was read; once more means with the same content.
   *
   * @param frame when
   * @param file its name
   * @param fingerprint of what was in it
   */
  public record FileRead(long frame, String file, int fingerprint) {}

  /** That of a box whose frames {@code clock} counts. */
  Determinism(BoxClock clock) {
    this.clock = clock;
  }

  /** The running frame may come out otherwise the next time; only the first reason is kept. */
  public void taint(String reason) {
    if (loss.isEmpty()) {
      loss = Optional.of(new Loss(clock.frame(), reason));
    }
  }

  /**
   * As {@link #taint}, when the clock of the wall drives the frames; in virtual time all is well.
   */
  public void loseInRealTime(String reason) {
    if (clock.inRealTime()) {
      taint(reason);
    }
  }

  /**
   * A program has read a file.
   *
   * @param fingerprint of what was in it
   */
  public void read(String file, int fingerprint) {
    if (files.size() < MAX_FILES) {
      files.add(new FileRead(clock.frame(), file, fingerprint));
    } else {
      taint(text("filesRead", MAX_FILES));
    }
  }

  /** Since when it is lost, and why; empty as long as it is not. */
  public Optional<Loss> loss() {
    return loss;
  }

  /** The files that programs have read, in their order. */
  public List<FileRead> files() {
    return List.copyOf(files);
  }
}
