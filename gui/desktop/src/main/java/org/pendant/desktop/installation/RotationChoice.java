package org.pendant.desktop.installation;

import java.util.ArrayList;
import java.util.List;
import org.pendant.desktop.unit.FormMemory;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.desktop.unit.RotationForm;
import org.pendant.kit.settings.Settings;

/** Rotation choice: how rotations are shown and typed on all pages, as on the other screens. */
final class RotationChoice {
  private final Settings settings;
  private final List<Runnable> listeners = new ArrayList<>();
  private RotationForm seen;

  /** As it was left. */
  RotationChoice(Settings settings) {
    this.settings = settings;
    seen = form();
  }

  /** Tells of another choice, which people make on other screens as well. */
  void look() {
    if (form() != seen) {
      seen = form();
      List.copyOf(listeners).forEach(Runnable::run);
    }
  }

  RotationForm form() {
    return FormMemory.read(settings).rotation();
  }

  void set(RotationForm next) {
    PoseForm now = FormMemory.read(settings);
    if (next != now.rotation()) {
      FormMemory.write(settings, new PoseForm(now.length(), now.angle(), next));
      look();
    }
  }

  void addListener(Runnable listener) {
    listeners.add(listener);
  }
}
