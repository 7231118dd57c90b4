package org.pendant.desktop.scene.view;

import org.pendant.desktop.scene.Picked;
import org.pendant.desktop.scene.mesh.Link;

/** Picked name: what people call the thing that the pointer is on. */
final class PickedName {
  private PickedName() {}

  static String of(Picked picked) {
    return switch (picked) {
      case Picked.OnLink on -> name(on.link());
      case Picked.OnTcp tcp -> "Tool centre point";
      case Picked.OnObject object -> object.name();
    };
  }

  private static String name(Link link) {
    return switch (link) {
      case BASE -> "Base";
      case SHOULDER -> "Shoulder";
      case UPPER_ARM -> "Upper arm";
      case FOREARM -> "Forearm";
      case WRIST_1 -> "Wrist 1";
      case WRIST_2 -> "Wrist 2";
      case WRIST_3 -> "Wrist 3, flange";
    };
  }
}
