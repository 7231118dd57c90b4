package org.pendant.recording;

import java.util.List;
import org.pendant.controller.device.DeviceState;
import org.pendant.controller.world.MovedObject;

/** Forms of what stands in the cell. */
final class CellForms {
  static final Form<List<MovedObject>> MOVED =
      new Form<MovedObject>() {
        @Override
        void write(MovedObject value, ByteSink out) {
          out.text(value.name());
          ArmForms.POSE.write(value.poseInBase(), out);
          out.bool(value.there());
        }

        @Override
        MovedObject read(ByteSource in) throws MalformedBytes {
          return new MovedObject(in.text(), ArmForms.POSE.read(in), in.bool());
        }
      }.list();

  static final Form<List<DeviceState>> DEVICES =
      new Form<DeviceState>() {
        @Override
        void write(DeviceState value, ByteSink out) {
          out.text(value.name());
          out.text(value.kind());
          out.number(value.strokeM());
          out.number(value.openingM());
          out.number(value.forceN());
          out.bool(value.on());
          out.number(value.mostM());
          out.number(value.partM());
          out.whole(value.port());
        }

        @Override
        DeviceState read(ByteSource in) throws MalformedBytes {
          return new DeviceState(
              in.text(),
              in.text(),
              in.number(),
              in.number(),
              in.number(),
              in.bool(),
              in.number(),
              in.number(),
              in.integer());
        }
      }.list();

  private CellForms() {}
}
