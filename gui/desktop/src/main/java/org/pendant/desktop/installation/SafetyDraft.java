package org.pendant.desktop.installation;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.safety.SafetyChecksum;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.kit.form.Measures;

/**
 * Safety draft: the safety configuration while the user changes it. It is locked until people say
 * that they want to, and takes effect when they apply it.
 */
final class SafetyDraft {
  private final Editing editing;
  private final List<Runnable> listeners = new ArrayList<>();
  private Optional<SafetyConfiguration> draft = Optional.empty();

  /** What is being typed, if it can be. */
  private Optional<SafetyConfiguration> typed = Optional.empty();

  /** What held when the user began to change it. */
  private Optional<SafetyConfiguration> begun = Optional.empty();

  SafetyDraft(Editing editing) {
    this.editing = editing;
  }

  /** What holds, as the installation says and the arm can have it. */
  SafetyConfiguration applied() {
    return editing.safety(editing.now());
  }

  /** What is shown: what holds, with the changes that are not applied yet. */
  SafetyConfiguration shown() {
    followInstallation();
    return draft.orElseGet(this::applied);
  }

  boolean unlocked() {
    followInstallation();
    return draft.isPresent();
  }

  /** Changes of what holds no more, because of another file or of Undo, are none. */
  private void followInstallation() {
    if (draft.isPresent() && !begun.equals(Optional.of(applied()))) {
      draft = Optional.empty();
    }
  }

  void unlock() {
    begun = Optional.of(applied());
    draft = begun;
    tell();
  }

  /** Forgets what was not applied, and locks. */
  void discard() {
    draft = Optional.empty();
    tell();
  }

  /** Changes the draft. */
  void edit(SafetyConfiguration next) {
    if (unlocked()) {
      draft = Optional.of(next);
      tell();
    }
  }

  /**
   * Why there cannot be such a configuration; empty if there can. It is proposed then, until the
   * draft changes or {@link #nothingTyped}.
   */
  String refusal(SafetyConfiguration next) {
    String why = editing.refusal(parts -> parts.safety = Optional.of(next));
    typed = why.isEmpty() ? Optional.of(next) : Optional.empty();
    return why;
  }

  /** What was typed is gone, or cannot be taken. */
  void nothingTyped() {
    typed = Optional.empty();
  }

  /** What does not hold yet but would: the draft, with what is being typed. */
  Optional<SafetyConfiguration> proposed() {
    return unlocked()
        ? typed.or(() -> draft).filter(each -> !each.equals(applied()))
        : Optional.empty();
  }

  boolean changed() {
    return !shown().equals(applied());
  }

  /** What differs from what holds, a line each. */
  List<String> changes() {
    return SafetyChanges.of(applied(), shown(), editing.measures());
  }

  SafetyChecksum checksum() {
    return SafetyChecksum.of(shown());
  }

  /** Makes it hold. What is standard for the arm is not written down. */
  void apply() {
    SafetyConfiguration next = shown();
    boolean standard = next.equals(SafetyConfiguration.standard(editing.arm()));
    draft = Optional.empty();
    editing.take(parts -> parts.safety = standard ? Optional.empty() : Optional.of(next));
    tell();
  }

  /** Tells {@code listener} of every change of the draft. */
  void addListener(Runnable listener) {
    listeners.add(listener);
  }

  private void tell() {
    typed = Optional.empty();
    List.copyOf(listeners).forEach(Runnable::run);
  }

  /** In what numbers are shown and typed. */
  Measures measures() {
    return editing.measures();
  }
}
