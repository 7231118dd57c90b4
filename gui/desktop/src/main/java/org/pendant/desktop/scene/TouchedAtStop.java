package org.pendant.desktop.scene;

import java.util.List;
import java.util.Optional;
import org.pendant.controller.safety.SafetyStop;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.StopPlace;
import org.pendant.controller.world.Contact;
import org.pendant.controller.world.Scene;

/**
 * Contact lookup: what the tool touched when a stop began; looked up once for each stop. Belongs to
 * one thread.
 */
public final class TouchedAtStop {
  private Optional<Asked> asked = Optional.empty();
  private List<Contact> contacts = List.of();

  private record Asked(SafetyStop stop, StopPlace place, Scene scene) {}

  /**
   * What is touched where the present stop began; nothing for one that is about where the arm
   * should go.
   *
   * @param scene what is around the arm
   */
  public List<Contact> of(ControllerState state, Scene scene) {
    Optional<SafetyStop> stop = state.safety().stop().filter(each -> !each.aboutTarget());
    Optional<StopPlace> place = state.safety().stopPlace();
    if (stop.isEmpty() || place.isEmpty() || scene.objects().isEmpty()) {
      return List.of();
    }
    Optional<Asked> now = Optional.of(new Asked(stop.get(), place.get(), scene));
    if (!asked.equals(now)) {
      asked = now;
      contacts =
          new Touching(scene)
              .contacts(
                  state.arm().kinematics(),
                  place.get().positionRad(),
                  state.arm().tool().inFlange());
    }
    return contacts;
  }
}
