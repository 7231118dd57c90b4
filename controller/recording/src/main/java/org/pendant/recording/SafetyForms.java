package org.pendant.recording;

import static org.pendant.recording.RecordingTexts.text;

import java.util.Optional;
import java.util.OptionalInt;
import org.pendant.controller.box.BaseLight;
import org.pendant.controller.safety.RobotMode;
import org.pendant.controller.safety.SafetyChecksum;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.controller.safety.SafetyStop;
import org.pendant.controller.safety.StopCategory;
import org.pendant.controller.state.SafetyStatus;
import org.pendant.controller.state.StopPlace;
import org.pendant.models.arm.Joints;

/** Forms of power, modes and stops. */
final class SafetyForms {
  private static final int BYTE = 255;

  private static final Form<Optional<SafetyStop>> STOP =
      new Form<SafetyStop>() {
        @Override
        void write(SafetyStop value, ByteSink out) {
          out.constant(value.mode());
          out.constant(value.category());
          out.whole(value.code());
          out.whole(value.argument());
          out.whole(value.joint().orElse(-1));
          out.number(value.timeS());
          out.number(value.value());
          out.number(value.limit());
          out.text(value.unit());
          out.text(value.message());
        }

        @Override
        SafetyStop read(ByteSource in) throws MalformedBytes {
          return new SafetyStop(
              in.constant(SafetyMode.class),
              in.constant(StopCategory.class),
              in.integer(),
              in.integer(),
              joint(in.integer()),
              in.number(),
              in.number(),
              in.number(),
              in.text(),
              in.text());
        }
      }.optional();

  private static final Form<Optional<StopPlace>> PLACE =
      new Form<StopPlace>() {
        @Override
        void write(StopPlace value, ByteSink out) {
          out.whole(value.line());
          ArmForms.POSE.write(value.tcpInBase(), out);
          ArmForms.JOINTS.write(value.positionRad(), out);
        }

        @Override
        StopPlace read(ByteSource in) throws MalformedBytes {
          return new StopPlace(in.integer(), ArmForms.POSE.read(in), ArmForms.JOINTS.read(in));
        }
      }.optional();

  private static final Form<BaseLight> LIGHT =
      new Form<>() {
        @Override
        void write(BaseLight value, ByteSink out) {
          switch (value) {
            case BaseLight.Standard standard -> out.byteOf(0);
            case BaseLight.Off off -> out.byteOf(1);
            case BaseLight.Solid solid -> {
              out.byteOf(2);
              out.unsigned(solid.red());
              out.unsigned(solid.green());
              out.unsigned(solid.blue());
            }
          }
        }

        @Override
        BaseLight read(ByteSource in) throws MalformedBytes {
          return switch (in.upTo(2)) {
            case 0 -> BaseLight.STANDARD;
            case 1 -> BaseLight.OFF;
            default -> new BaseLight.Solid(in.upTo(BYTE), in.upTo(BYTE), in.upTo(BYTE));
          };
        }
      };

  static final Form<SafetyStatus> STATUS =
      new Form<>() {
        @Override
        void write(SafetyStatus value, ByteSink out) {
          out.constant(value.robotMode());
          out.constant(value.safetyMode());
          STOP.write(value.stop(), out);
          PLACE.write(value.stopPlace(), out);
          out.bool(value.reduced());
          LIGHT.write(value.baseLight(), out);
          out.bool(value.shutDown());
          out.whole(value.checksum().value());
        }

        @Override
        SafetyStatus read(ByteSource in) throws MalformedBytes {
          return new SafetyStatus(
              in.constant(RobotMode.class),
              in.constant(SafetyMode.class),
              STOP.read(in),
              PLACE.read(in),
              in.bool(),
              LIGHT.read(in),
              in.bool(),
              new SafetyChecksum(in.integer()));
        }
      };

  private SafetyForms() {}

  private static OptionalInt joint(int number) throws MalformedBytes {
    if (number >= Joints.COUNT) {
      throw new MalformedBytes(text("jointOutside", number, Joints.COUNT));
    }
    return number < 0 ? OptionalInt.empty() : OptionalInt.of(number);
  }
}
