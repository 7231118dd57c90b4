package org.pendant.desktop.cell;

import java.util.List;
import org.pendant.controller.device.DeviceField;
import org.pendant.controller.device.DeviceKind;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.scene.DeviceHandles;

/**
 * Device places: where a device is in the base: one place, two ends, or the corners of a box.
 *
 * @param device as a file says it
 * @param keys of its places
 */
record DevicePlaces(DeviceText device, List<String> keys) {
  private static final String LEAST = "min";
  private static final String GREATEST = "max";

  /** Copies the list. */
  DevicePlaces {
    keys = List.copyOf(keys);
  }

  static DevicePlaces of(DeviceText device) {
    List<DeviceField> fields =
        DeviceKind.of(device.type()).map(DeviceKind::fields).orElse(List.of());
    return new DevicePlaces(
        device,
        fields.stream().filter(DeviceField.Place.class::isInstance).map(DeviceField::key).toList());
  }

  /**
   * Where it is held.
   *
   * @param key of a place; {@link DeviceHandles#WHOLE} for the middle of all
   */
  Vector3 anchorM(String key) {
    if (!key.equals(DeviceHandles.WHOLE)) {
      return device.place(key);
    }
    Vector3 sum = new Vector3(0, 0, 0);
    for (String each : keys) {
      Vector3 place = device.place(each);
      sum = new Vector3(sum.x() + place.x(), sum.y() + place.y(), sum.z() + place.z());
    }
    int count = Math.max(1, keys.size());
    return new Vector3(sum.x() / count, sum.y() / count, sum.z() / count);
  }

  /**
   * The device with what it is held by elsewhere.
   *
   * @param key as in {@link #anchorM}
   * @param toM where to, m
   */
  DeviceText moved(String key, Vector3 toM) {
    if (!key.equals(DeviceHandles.WHOLE)) {
      return device.withPlace(key, rounded(within(key, toM)));
    }
    Vector3 from = anchorM(key);
    DeviceText next = device;
    for (String each : keys) {
      Vector3 place = device.place(each);
      next =
          next.withPlace(
              each,
              rounded(
                  new Vector3(
                      place.x() + toM.x() - from.x(),
                      place.y() + toM.y() - from.y(),
                      place.z() + toM.z() - from.z())));
    }
    return next;
  }

  /** A corner of a box goes no farther than the one across. */
  private Vector3 within(String key, Vector3 toM) {
    if (key.equals(LEAST)) {
      Vector3 most = device.place(GREATEST);
      return new Vector3(
          Math.min(toM.x(), most.x()), Math.min(toM.y(), most.y()), Math.min(toM.z(), most.z()));
    }
    if (key.equals(GREATEST)) {
      Vector3 least = device.place(LEAST);
      return new Vector3(
          Math.max(toM.x(), least.x()), Math.max(toM.y(), least.y()), Math.max(toM.z(), least.z()));
    }
    return toM;
  }

  /** As people would write it, to a hundredth of a millimetre. */
  private static Vector3 rounded(Vector3 placeM) {
    return new Vector3(rounded(placeM.x()), rounded(placeM.y()), rounded(placeM.z()));
  }

  private static double rounded(double valueM) {
    return Math.round(valueM * 1e5) / 1e5;
  }
}
