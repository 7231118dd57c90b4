package org.pendant.desktop.unit;

import java.util.ArrayList;
import java.util.List;
import org.pendant.kit.settings.Settings;

/** Rotation choice: how rotations are shown and typed on all pages, as on the other screens. */
public final class RotationChoice {
  private final Settings settings;
  private final List<Runnable> listeners = new ArrayList<>();
  private PoseForm seen;

  /** As it was left. */
  public RotationChoice(Settings settings) {
    this.settings = settings;
    seen = FormMemory.read(settings);
  }

  /** Tells of another choice, of units as well, which people make on other screens too. */
  public void look() {
    PoseForm now = FormMemory.read(settings);
    if (!now.equals(seen)) {
      seen = now;
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
