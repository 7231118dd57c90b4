package org.pendant.recording;

import java.util.List;
import org.pendant.controller.device.DeviceState;
import org.pendant.controller.wire.SignalGroupState;
import org.pendant.controller.world.MovedObject;

/** Forms of what stands in the cell. */
final class CellForms {
  private static final Form<List<Integer>> VALUES =
      new Form<Integer>() {
        @Override
        void write(Integer value, ByteSink out) {
          out.whole(value);
        }

        @Override
        Integer read(ByteSource in) throws MalformedBytes {
          return in.integer();
        }
      }.list();

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

  private static final Form<List<SignalGroupState>> SIGNALS =
      new Form<SignalGroupState>() {
        @Override
        void write(SignalGroupState value, ByteSink out) {
          out.text(value.name());
          out.whole(value.first());
          out.bool(value.digital());
          out.bool(value.settable());
          VALUES.write(value.values(), out);
        }

        @Override
        SignalGroupState read(ByteSource in) throws MalformedBytes {
          return new SignalGroupState(
              in.text(), in.integer(), in.bool(), in.bool(), VALUES.read(in));
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
          out.number(value.maxPartWidthM());
          out.number(value.partWidthM());
          out.whole(value.port());
          out.whole(value.procedurePort());
          SIGNALS.write(value.signals(), out);
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
              in.integer(),
              in.integer(),
              SIGNALS.read(in));
        }
      }.list();

  private CellForms() {}
}
