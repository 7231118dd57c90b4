package org.pendant.desktop.timeline;

import static org.pendant.desktop.timeline.TimelineTexts.text;

import java.awt.EventQueue;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.IntFunction;
import org.pendant.controller.disk.FileTrouble;
import org.pendant.desktop.workbench.Workbench;
import org.pendant.kit.text.Messages;
import org.pendant.recording.Recording;
import org.pendant.recording.RecordingFile;
import org.pendant.recording.compare.FirstDifference;

/** Earlier run: compares the last run of the timeline with that of a recording. */
public final class EarlierRun {
  /** What of a difference has room in a notice. */
  private static final int MAX_VALUES = 1;

  private final Workbench workbench;
  private final LookBack lookBack;
  private final IntFunction<String> place;

  /**
   * A comparison for a timeline.
   *
   * @param lookBack shows the moment of the first difference
   * @param place what a line of the program of that moment is called
   */
  public EarlierRun(Workbench workbench, LookBack lookBack, IntFunction<String> place) {
    this.workbench = workbench;
    this.lookBack = lookBack;
    this.place = place;
  }

  /** Says what differs first from the run in a file, and goes there; it is read elsewhere. */
  public void compareWith(Path file) {
    Recording recording = lookBack.recording();
    workbench.notify(text("comparingTheLastRunWith", file.getFileName()));
    Thread.ofVirtual().name("earlier run").start(() -> compare(recording, file));
  }

  private void compare(Recording recording, Path file) {
    try {
      Optional<FirstDifference> difference =
          FirstDifference.between(recording, RecordingFile.open(file).recording());
      long frames = FirstDifference.framesOfRun(recording).orElse(0L);
      EventQueue.invokeLater(() -> show(difference, frames, file.getFileName()));
    } catch (UncheckedIOException e) {
      tell(text("fileNotCompared", file, FileTrouble.reason(e.getCause())));
    } catch (IOException e) {
      tell(text("fileNotCompared", file, FileTrouble.reason(e)));
    } catch (IllegalArgumentException e) {
      tell(text("notCompared", e.getMessage()));
    }
  }

  private void tell(String text) {
    EventQueue.invokeLater(() -> workbench.notify(text));
  }

  private void show(Optional<FirstDifference> difference, long frames, Path name) {
    if (difference.isEmpty()) {
      workbench.notify(text("theLastRunEqualsInAll", name, frames));
      return;
    }
    workbench.show(TimelineView.ID);
    lookBack.jump(difference.get().nowS());
    workbench.notify(
        text(
            "comparedWithTheLastRun",
            name,
            Messages.shown(difference.get().words(place, MAX_VALUES))));
  }
}
