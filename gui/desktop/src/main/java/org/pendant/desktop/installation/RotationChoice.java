package org.pendant.desktop.installation;

import java.util.ArrayList;
import java.util.List;
import org.pendant.desktop.move.RotationForm;
import org.pendant.kit.settings.Settings;

/**
 * Rotation choice: how rotations are shown and typed on all pages; kept from one start to the next.
 */
final class RotationChoice {
  private static final String KEY = "installation.rotation";

  private final Settings settings;
  private final List<Runnable> listeners = new ArrayList<>();
  private RotationForm form;

  /** As it was left. */
  RotationChoice(Settings settings) {
    this.settings = settings;
    form =
        settings.get(KEY).filter(RotationForm.ROLL_PITCH_YAW.name()::equals).isPresent()
            ? RotationForm.ROLL_PITCH_YAW
            : RotationForm.VECTOR;
  }

  RotationForm form() {
    return form;
  }

  void set(RotationForm next) {
    if (next != form) {
      form = next;
      settings.put(KEY, next.name());
      List.copyOf(listeners).forEach(Runnable::run);
    }
  }

  void addListener(Runnable listener) {
    listeners.add(listener);
  }
}
