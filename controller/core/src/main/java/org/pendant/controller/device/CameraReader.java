package org.pendant.controller.device;

import static org.pendant.controller.device.DeviceTexts.text;

import org.pendant.controller.device.camera.PartCamera;
import org.pendant.models.json.JsonException;

/** Camera reader: reads cameras, each of which has ports of its own. */
final class CameraReader {
  private static final String PORT = "port";
  private static final String PROCEDURES = "rpc";
  private static final String OCCLUSION = "occlusion";

  private final DevicePorts ports;

  CameraReader(DevicePorts ports) {
    this.ports = ports;
  }

  DeviceSetup camera(String name, FieldReader fields, PartReader parts) throws JsonException {
    boolean occlusion = fields.flag(OCCLUSION);
    if (occlusion && fields.spot("at").isEmpty()) {
      throw fields.all().required(OCCLUSION).place().refusal(text("occlusionWithoutPlace"));
    }
    return new DeviceSetup.Camera(
        name,
        fields.area("min", "max"),
        parts.named(fields, "objects"),
        fields.spot("at"),
        occlusion,
        new DeviceSetup.Camera.Ports(
            ports.take(name, fields, PORT), ports.take(name, fields, PROCEDURES)),
        new PartCamera.Errors(
            fields.number("noise"), fields.number("turn_noise"), (long) fields.number("seed")));
  }
}
