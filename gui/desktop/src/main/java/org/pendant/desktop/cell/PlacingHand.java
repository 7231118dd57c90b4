package org.pendant.desktop.cell;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.scene.view.ObjectHand;
import org.pendant.desktop.session.SceneDraft;

/** Placing hand: moves the objects of a draft when they are dragged in 3D. */
final class PlacingHand implements ObjectHand {
  static final double STEP_M = 0.01;
  static final double FINE_STEP_M = 0.001;

  private final SceneDraft draft;
  private final BooleanSupplier active;
  private final Consumer<String> chosen;
  private Optional<SceneObject> held = Optional.empty();

  /**
   * A hand that holds nothing.
   *
   * @param active whether objects can be moved now
   * @param chosen told the name of what is held
   */
  PlacingHand(SceneDraft draft, BooleanSupplier active, Consumer<String> chosen) {
    this.draft = draft;
    this.active = active;
    this.chosen = chosen;
  }

  @Override
  public boolean grabs() {
    return active.getAsBoolean();
  }

  /** A plane has no place that the pointer could be on: the view turns. */
  @Override
  public boolean begin(String name) {
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
  public void move(Vector3 wayInBaseM, boolean fine) {
    if (held.isEmpty()) {
      return;
    }
    Vector3 from = ObjectShape.placeM(held.get());
    double stepM = fine ? FINE_STEP_M : STEP_M;
    Vector3 to =
        new Vector3(
            stepped(from.x(), wayInBaseM.x(), stepM),
            stepped(from.y(), wayInBaseM.y(), stepM),
            stepped(from.z(), wayInBaseM.z(), stepM));
    String name = held.get().name();
    List<SceneObject> next = new ArrayList<>(draft.scene().objects());
    next.replaceAll(each -> each.name().equals(name) ? at(each, to) : each);
    Scene now = draft.scene();
    try {
      draft.set(now.withObjects(next));
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

  /** What does not go along an axis keeps its place there, on a step or not. */
  private static double stepped(double fromM, double wayM, double stepM) {
    // by whole numbers: a place reads as people would write it
    double steps = Math.round(1 / stepM);
    return wayM == 0 ? fromM : Math.round((fromM + wayM) * steps) / steps;
  }

  @Override
  public void end() {
    held = Optional.empty();
    draft.endRow();
  }
}
