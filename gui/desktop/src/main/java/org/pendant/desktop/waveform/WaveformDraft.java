package org.pendant.desktop.waveform;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;

/** Waveform draft: the sheet that is edited, and who hears of changes. */
final class WaveformDraft {
  /** More steps back nobody remembers. */
  private static final int MAX_STEPS = 200;

  private final List<Runnable> listeners = new ArrayList<>();
  private Steps steps;

  /** Steps of a draft: the sheet, what it was before, and what it was before that was undone. */
  static final class Steps {
    private final Deque<WaveSheet> before = new ArrayDeque<>();
    private final Deque<WaveSheet> after = new ArrayDeque<>();
    private WaveSheet sheet;

    Steps(WaveSheet sheet) {
      this.sheet = sheet;
    }

    WaveSheet sheet() {
      return sheet;
    }
  }

  WaveformDraft(Steps steps) {
    this.steps = steps;
  }

  WaveSheet sheet() {
    return steps.sheet;
  }

  Steps steps() {
    return steps;
  }

  /** Edits something else from now on; what was edited stays as it is. */
  void open(Steps other) {
    steps = other;
    tell();
  }

  /** Tells {@code listener} of every change. */
  void addListener(Runnable listener) {
    listeners.add(listener);
  }

  /** Another sheet from now on; {@link #undo} takes it back. */
  void set(WaveSheet next) {
    if (next.equals(steps.sheet)) {
      return;
    }
    steps.before.push(steps.sheet);
    if (steps.before.size() > MAX_STEPS) {
      steps.before.removeLast();
    }
    steps.after.clear();
    show(next);
  }

  boolean canUndo() {
    return !steps.before.isEmpty();
  }

  boolean canRedo() {
    return !steps.after.isEmpty();
  }

  void undo() {
    if (canUndo()) {
      steps.after.push(steps.sheet);
      show(steps.before.pop());
    }
  }

  void redo() {
    if (canRedo()) {
      steps.before.push(steps.sheet);
      show(steps.after.pop());
    }
  }

  private void show(WaveSheet next) {
    steps.sheet = next;
    tell();
  }

  private void tell() {
    List.copyOf(listeners).forEach(Runnable::run);
  }
}
