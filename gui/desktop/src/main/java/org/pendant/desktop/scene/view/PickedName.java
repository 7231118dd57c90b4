package org.pendant.desktop.scene.view;

import static org.pendant.desktop.scene.view.PictureTexts.text;

import org.pendant.desktop.scene.Picked;
import org.pendant.desktop.scene.mesh.Link;

/** Picked name: what people call the thing that the pointer is on. */
final class PickedName {
  private PickedName() {}

  static String of(Picked picked) {
    return switch (picked) {
      case Picked.OnLink on -> name(on.link());
      case Picked.OnTcp tcp -> text("toolCentrePoint");
      case Picked.OnObject object -> object.name();
    };
  }

  private static String name(Link link) {
    return switch (link) {
      case BASE -> text("base");
      case SHOULDER -> text("shoulder");
      case UPPER_ARM -> text("upperArm");
      case FOREARM -> text("forearm");
      case WRIST_1 -> text("wrist1");
      case WRIST_2 -> text("wrist2");
      case WRIST_3 -> text("wrist3Flange");
    };
  }
}
