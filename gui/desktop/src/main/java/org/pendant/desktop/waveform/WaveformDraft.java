package org.pendant.desktop.waveform;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;

/** Waveform draft: the sheet that is edited, what it was before, and who hears of changes. */
final class WaveformDraft {
  /** More steps back nobody remembers. */
  private static final int MAX_STEPS = 200;

  private final Deque<WaveSheet> before = new ArrayDeque<>();
  private final Deque<WaveSheet> after = new ArrayDeque<>();
  private final List<Runnable> listeners = new ArrayList<>();
  private WaveSheet sheet;

  WaveformDraft(WaveSheet sheet) {
    this.sheet = sheet;
  }

  WaveSheet sheet() {
    return sheet;
  }

  /** Tells {@code listener} of every change. */
  void addListener(Runnable listener) {
    listeners.add(listener);
  }

  /** Another sheet from now on; {@link #undo} takes it back. */
  void set(WaveSheet next) {
    if (next.equals(sheet)) {
      return;
    }
    before.push(sheet);
    if (before.size() > MAX_STEPS) {
      before.removeLast();
    }
    after.clear();
    show(next);
  }

  boolean canUndo() {
    return !before.isEmpty();
  }

  boolean canRedo() {
    return !after.isEmpty();
  }

  void undo() {
    if (canUndo()) {
      after.push(sheet);
      show(before.pop());
    }
  }

  void redo() {
    if (canRedo()) {
      before.push(sheet);
      show(after.pop());
    }
  }

  private void show(WaveSheet next) {
    sheet = next;
    List.copyOf(listeners).forEach(Runnable::run);
  }
}
