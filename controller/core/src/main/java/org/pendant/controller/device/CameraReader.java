package org.pendant.controller.device;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.pendant.controller.device.camera.PartCamera;
import org.pendant.models.json.JsonException;

/** Camera reader: reads cameras, each of which has ports of its own. */
final class CameraReader {
  private static final String PORT = "port";
  private static final String PROCEDURES = "rpc";

  /** What else is at ports of the controller that a camera may be given. */
  private static final List<Integer> TAKEN =
      List.of(
          29_999, 30_001, 30_002, 30_003, 30_004, 30_011, 30_012, 30_013, 30_020, 40_000, 41_414,
          44_818, 54_321, 63_352);

  private final Map<Integer, String> ports = new HashMap<>();

  DeviceSetup camera(String name, FieldReader fields, PartReader parts) throws JsonException {
    return new DeviceSetup.Camera(
        name,
        fields.area("min", "max"),
        parts.named(fields, "objects"),
        fields.spot("at"),
        new DeviceSetup.Camera.Ports(port(name, fields, PORT), port(name, fields, PROCEDURES)),
        new PartCamera.Errors(
            fields.number("noise"), fields.number("turn_noise"), (long) fields.number("seed")));
  }

  private int port(String name, FieldReader fields, String key) throws JsonException {
    int port = (int) fields.number(key);
    String owner = TAKEN.contains(port) ? "the controller" : ports.putIfAbsent(port, name);
    if (owner != null) {
      throw (fields.has(key) ? fields.all().required(key).place() : fields.all().place())
          .refusal(
              key
                  + " is "
                  + port
                  + (owner.equals(name) ? " as the other" : ", which " + owner + " has")
                  + ", must be another");
    }
    return port;
  }
}
