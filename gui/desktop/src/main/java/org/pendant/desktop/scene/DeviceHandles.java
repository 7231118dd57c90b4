package org.pendant.desktop.scene;

import java.util.ArrayList;
import java.util.List;
import org.pendant.controller.device.Zone;
import org.pendant.controller.world.Vector3;

/** Device handles: the places at which devices of the cell are held to be dragged. */
public final class DeviceHandles {
  /** The key of a handle that moves all of a device. */
  public static final String WHOLE = "";

  private DeviceHandles() {}

  /**
   * A handle.
   *
   * @param device its name
   * @param key of the place in the file that it moves; {@link #WHOLE} for all of them
   * @param placeM where it is in the base, m
   */
  public record Handle(String device, String key, Vector3 placeM) {}

  /** Those of all devices that have a place of their own. */
  public static List<Handle> of(DeviceSight devices) {
    List<Handle> handles = new ArrayList<>();
    for (DeviceSight.Sensor each : devices.sensors()) {
      switch (each.zone()) {
        case Zone.Ball ball -> handles.add(new Handle(each.name(), WHOLE, vector(ball.at())));
        case Zone.Beam beam -> addTwo(handles, each.name(), "from", beam.from(), "to", beam.to());
        case Zone.Area area -> addTwo(handles, each.name(), "min", area.min(), "max", area.max());
      }
    }
    return handles.stream()
        .map(each -> new Handle(each.device(), each.key(), devices.placed(each.placeM())))
        .toList();
  }

  /** Those of both ends, and one in the middle that moves both. */
  private static void addTwo(
      List<Handle> handles,
      String device,
      String key,
      Zone.Place one,
      String otherKey,
      Zone.Place other) {
    Vector3 a = vector(one);
    Vector3 b = vector(other);
    Vector3 middle = new Vector3((a.x() + b.x()) / 2, (a.y() + b.y()) / 2, (a.z() + b.z()) / 2);
    handles.add(new Handle(device, WHOLE, middle));
    handles.add(new Handle(device, key, a));
    handles.add(new Handle(device, otherKey, b));
  }

  private static Vector3 vector(Zone.Place place) {
    return new Vector3(place.x(), place.y(), place.z());
  }
}
