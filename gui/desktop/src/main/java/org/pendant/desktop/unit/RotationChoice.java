package org.pendant.desktop.unit;

import java.util.ArrayList;
import java.util.List;
import org.pendant.kit.settings.Settings;

/** Rotation choice: how rotations are shown and typed on all pages, as on the other screens. */
public final class RotationChoice {
  private final Settings settings;
  private final List<Runnable> listeners = new ArrayList<>();
  private RotationForm seen;

  /** As it was left. */
  public RotationChoice(Settings settings) {
    this.settings = settings;
    seen = form();
  }

  /** Tells of another choice, which people make on other screens as well. */
  public void look() {
    if (form() != seen) {
      seen = form();
      List.copyOf(listeners).forEach(Runnable::run);
    }
  }

  public RotationForm form() {
    return FormMemory.read(settings).rotation();
  }

  public void set(RotationForm next) {
    PoseForm now = FormMemory.read(settings);
    if (next != now.rotation()) {
      FormMemory.write(settings, new PoseForm(now.length(), now.angle(), next));
      look();
    }
  }

  public void addListener(Runnable listener) {
    listeners.add(listener);
  }
}
