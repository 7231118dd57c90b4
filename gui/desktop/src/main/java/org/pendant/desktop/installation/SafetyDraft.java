package org.pendant.desktop.installation;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.safety.FittedSafety;
import org.pendant.controller.safety.SafetyChecksum;
import org.pendant.controller.safety.SafetyConfiguration;

/**
 * Safety draft: the safety configuration while the user changes it. It is locked until people say
 * that they want to, and takes effect when they apply it.
 */
final class SafetyDraft {
  private final Editing editing;
  private final List<Runnable> listeners = new ArrayList<>();
  private Optional<SafetyConfiguration> draft = Optional.empty();

  /** What held when the user began to change it. */
  private Optional<SafetyConfiguration> begun = Optional.empty();

  SafetyDraft(Editing editing) {
    this.editing = editing;
  }

  /** What holds, as the installation says and the arm can have it. */
  SafetyConfiguration applied() {
    return editing
        .now()
        .safety()
        .map(each -> FittedSafety.of(each, editing.arm()).configuration())
        .orElseGet(() -> SafetyConfiguration.standard(editing.arm()));
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

  /** Why there cannot be such a configuration; empty if there can. */
  String refusal(SafetyConfiguration next) {
    return editing.refusal(parts -> parts.safety = Optional.of(next));
  }

  boolean changed() {
    return !shown().equals(applied());
  }

  /** What differs from what holds, a line each. */
  List<String> changes() {
    return SafetyChanges.of(applied(), shown());
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
    List.copyOf(listeners).forEach(Runnable::run);
  }
}
