package org.pendant.desktop.cell;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Function;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.scene.DeviceHandles;
import org.pendant.desktop.scene.view.ObjectHand;
import org.pendant.desktop.session.SceneDraft;

/** Placing hand: moves the objects and devices of a draft when they are dragged in 3D. */
final class PlacingHand implements ObjectHand {
  static final double STEP_M = 0.01;
  static final double FINE_STEP_M = 0.001;

  private final SceneDraft draft;
  private final BooleanSupplier active;
  private final Consumer<String> chosen;
  private final Consumer<String> deviceChosen;
  private final Function<Vector3, String> placeWords;
  private final Runnable putDown;
  private Optional<SceneObject> held = Optional.empty();
  private Optional<HeldDevice> device = Optional.empty();
  private String words = "";

  /** A device as it was when it was held, and by what. */
  private record HeldDevice(DeviceText before, DeviceHandles.Handle handle) {}

  /**
   * A hand that holds nothing.
   *
   * @param active whether objects can be moved now
   * @param chosen told the name of an object that is held
   * @param deviceChosen told the name of a device that is held
   * @param placeWords a place in the base, m, for people
   * @param putDown told when what was held is let go
   */
  PlacingHand(
      SceneDraft draft,
      BooleanSupplier active,
      Consumer<String> chosen,
      Consumer<String> deviceChosen,
      Function<Vector3, String> placeWords,
      Runnable putDown) {
    this.draft = draft;
    this.active = active;
    this.chosen = chosen;
    this.deviceChosen = deviceChosen;
    this.placeWords = placeWords;
    this.putDown = putDown;
  }

  @Override
  public boolean grabs(boolean key) {
    return active.getAsBoolean();
  }

  /** A plane has no place that the pointer could be on: the view turns. */
  @Override
  public boolean begin(String name, Vector3 pointInBaseM) {
    held =
        draft.scene().objects().stream()
            .filter(each -> each.name().equals(name) && !(each instanceof SceneObject.Plane))
            .findFirst();
    held.ifPresent(
        object -> {
          chosen.accept(name);
          draft.beginRow();
        });
    return held.isPresent();
  }

  @Override
  public boolean begin(DeviceHandles.Handle handle) {
    device =
        Equipment.devices(draft.equipment()).stream()
            .filter(each -> each.name().equals(handle.device()))
            .findFirst()
            .map(before -> new HeldDevice(before, handle));
    device.ifPresent(
        each -> {
          deviceChosen.accept(handle.device());
          draft.beginRow();
        });
    return device.isPresent();
  }

  @Override
  public void move(Vector3 wayInBaseM, boolean fine) {
    double stepM = fine ? FINE_STEP_M : STEP_M;
    device.ifPresent(now -> moveDevice(now, wayInBaseM, stepM));
    if (held.isEmpty()) {
      return;
    }
    Vector3 from = ObjectShape.placeM(held.get());
    Vector3 to = stepped(from, wayInBaseM, stepM);
    String name = held.get().name();
    List<SceneObject> next = new ArrayList<>(draft.scene().objects());
    next.replaceAll(each -> each.name().equals(name) ? at(each, to) : each);
    Scene now = draft.scene();
    try {
      draft.set(now.withObjects(next));
      words = placeWords.apply(to);
    } catch (IllegalArgumentException _) {
      // in another one it stays where it was before
    }
  }

  /** Where there is no room for it, it stays. */
  private static SceneObject at(SceneObject object, Vector3 placeM) {
    try {
      return ObjectShape.at(object, placeM);
    } catch (IllegalArgumentException _) {
      return object;
    }
  }

  private void moveDevice(HeldDevice now, Vector3 wayM, double stepM) {
    DevicePlaces places = DevicePlaces.of(now.before);
    Vector3 from = places.anchorM(now.handle.key());
    Vector3 to = stepped(from, wayM, stepM);
    DeviceText after = places.moved(now.handle.key(), to);
    List<DeviceText> next = new ArrayList<>(Equipment.devices(draft.equipment()));
    next.replaceAll(each -> each.name().equals(after.name()) ? after : each);
    Map<String, String> members = Equipment.with(draft.equipment(), next);
    // where there is no room for it, it stays
    if (Equipment.refusal(draft.scene(), members).isEmpty()) {
      draft.setEquipment(members);
      words = placeWords.apply(DevicePlaces.of(after).anchorM(now.handle.key()));
    }
  }

  private static Vector3 stepped(Vector3 from, Vector3 wayM, double stepM) {
    return new Vector3(
        stepped(from.x(), wayM.x(), stepM),
        stepped(from.y(), wayM.y(), stepM),
        stepped(from.z(), wayM.z(), stepM));
  }

  /** What does not go along an axis keeps its place there, on a step or not. */
  private static double stepped(double fromM, double wayM, double stepM) {
    // by whole numbers: a place reads as people would write it
    double steps = Math.round(1 / stepM);
    return wayM == 0 ? fromM : Math.round((fromM + wayM) * steps) / steps;
  }

  @Override
  public String words() {
    return words;
  }

  @Override
  public void end() {
    boolean holds = held.isPresent() || device.isPresent();
    held = Optional.empty();
    device = Optional.empty();
    words = "";
    draft.endRow();
    if (holds) {
      putDown.run();
    }
  }
}
