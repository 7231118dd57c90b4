package org.pendant.recording;

import static org.pendant.recording.RecordingTexts.text;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmFile;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Calibration;
import org.pendant.models.calibration.CalibrationFile;
import org.pendant.models.calibration.CalibrationTrouble;
import org.pendant.models.json.JsonException;
import org.pendant.models.time.FrameTime;

/**
 * File format of a recording: what its file begins with, and what is in it; docs/recording.md
 * describes it.
 */
final class FileFormat {
  /** What every recording begins with. */
  static final byte[] MAGIC = {(byte) 0x8F, 'P', 'E', 'N', 'R', 'E', 'C', '\n'};

  /** The version that is written, and the only one that is read. */
  static final int VERSION = 6;

  /** Frames of a segment. */
  static final int FRAMES = 1;

  /** The text of a program that has started. */
  static final int PROGRAM = 2;

  /** The end: a file without it is not whole. */
  static final int END = 3;

  /** What stands before each block: kind, inflated and deflated length, checksum. */
  static final int BLOCK_HEADER = 1 + 3 * Integer.BYTES;

  /** A larger block is no block. */
  static final int MAX_BLOCK_BYTES = 64 << 20;

  /** A longer header is no header. */
  static final int MAX_HEADER_BYTES = 1 << 16;

  /** How often Deflate can make anything smaller, at most. */
  static final int MAX_RATIO = 1040;

  /** Where a recording comes from that a client of RTDE has made. */
  private static final String RTDE = "rtde";

  private FileFormat() {}

  /**
   * What a header says.
   *
   * @param arm that moves
   * @param received whether a controller was listened to, instead of being looked into
   */
  record Header(ArmDescription arm, boolean received) {}

  /**
   * Robot, frames per second, and the columns with the count of their numbers; then, as far as
   * there is anything to be said, the calibration of the arm, the description of an arm that is not
   * exactly its model, and where the recording comes from.
   */
  static void writeHeader(Header header, ByteSink out) {
    ArmDescription arm = header.arm();
    out.text(arm.id());
    out.count(FrameTime.FRAMES_PER_SECOND);
    out.count(NumberGroup.COUNT);
    for (NumberGroup each : NumberGroup.values()) {
      out.text(each.column());
      out.count(each.size());
    }
    out.count(SnapshotPart.COUNT);
    for (SnapshotPart each : SnapshotPart.PARTS) {
      out.text(each.column());
    }
    List<String> more = new ArrayList<>();
    more.add(
        arm.calibration().equals(Calibration.NONE) ? "" : CalibrationFile.text(arm.calibration()));
    ArmDescription bare = arm.withCalibration(Calibration.NONE);
    more.add(bare.equals(ArmLibrary.load(arm.id())) ? "" : ArmFile.text(bare));
    more.add(header.received() ? RTDE : "");
    while (!more.isEmpty() && more.getLast().isEmpty()) {
      more.removeLast();
    }
    more.forEach(out::text);
  }

  /** Reads what {@link #writeHeader} has written and compares it with what this version knows. */
  static Header readHeader(ByteSource in) throws MalformedBytes {
    String robotId = in.text();
    if (!ArmLibrary.ids().contains(robotId)) {
      throw new MalformedBytes(text("unknownRobot"));
    }
    int framesPerSecond = in.upTo(Integer.MAX_VALUE);
    if (framesPerSecond != FrameTime.FRAMES_PER_SECOND) {
      throw new MalformedBytes(
          text("framesPerSecond", framesPerSecond, FrameTime.FRAMES_PER_SECOND));
    }
    List<String> found = new ArrayList<>();
    int groups = in.count(2);
    for (int i = 0; i < groups; i++) {
      found.add(in.text() + " " + in.upTo(Integer.MAX_VALUE));
    }
    int parts = in.count(1);
    for (int i = 0; i < parts; i++) {
      found.add(in.text());
    }
    if (!found.equals(columns())) {
      throw new MalformedBytes(text("otherColumns", VERSION));
    }
    // older files end earlier, as there was nothing more that could be said
    String calibration = in.left() == 0 ? "" : in.text();
    String ownArm = in.left() == 0 ? "" : in.text();
    String origin = in.left() == 0 ? "" : in.text();
    if (!origin.isEmpty() && !origin.equals(RTDE)) {
      throw new MalformedBytes(text("unknownOrigin"));
    }
    ArmDescription arm = ownArm.isEmpty() ? ArmLibrary.load(robotId) : ownArm(robotId, ownArm);
    return new Header(
        calibration.isEmpty() ? arm : arm.withCalibration(calibration(calibration)),
        !origin.isEmpty());
  }

  private static ArmDescription ownArm(String robotId, String text) throws MalformedBytes {
    try {
      ArmDescription arm =
          ArmFile.read(
              text("itsArm"), new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)));
      if (!arm.id().equals(robotId)) {
        throw new MalformedBytes(text("itsArmIsAnother", arm.id(), robotId));
      }
      return arm;
    } catch (JsonException e) {
      throw new MalformedBytes(text("armUnreadable", e.getMessage()));
    }
  }

  private static Calibration calibration(String text) throws MalformedBytes {
    try {
      return CalibrationFile.ofText(text);
    } catch (CalibrationTrouble e) {
      throw new MalformedBytes(text("calibrationUnreadable", e.getMessage()));
    }
  }

  private static List<String> columns() {
    List<String> columns = new ArrayList<>();
    for (NumberGroup each : NumberGroup.values()) {
      columns.add(each.column() + " " + each.size());
    }
    for (SnapshotPart each : SnapshotPart.PARTS) {
      columns.add(each.column());
    }
    return columns;
  }
}
