package org.pendant.recording;

import java.util.ArrayList;
import java.util.List;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Calibration;
import org.pendant.models.calibration.CalibrationFile;
import org.pendant.models.calibration.CalibrationTrouble;
import org.pendant.models.time.FrameTime;

/**
 * File format of a recording: what its file begins with, and what is in it; docs/recording.md
 * describes it.
 */
final class FileFormat {
  /** What every recording begins with. */
  static final byte[] MAGIC = {(byte) 0x8F, 'P', 'E', 'N', 'R', 'E', 'C', '\n'};

  /** The version that is written, and the only one that is read. */
  static final int VERSION = 2;

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

  private FileFormat() {}

  /**
   * Robot, frames per second, and the columns with the count of their numbers; then the calibration
   * of the arm, if it has one.
   */
  static void writeHeader(ArmDescription arm, ByteSink out) {
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
    if (!arm.calibration().equals(Calibration.NONE)) {
      out.text(CalibrationFile.text(arm.calibration()));
    }
  }

  /**
   * Reads what {@link #writeHeader} has written and compares it with what this version knows.
   *
   * @return the arm
   */
  static ArmDescription readHeader(ByteSource in) throws MalformedBytes {
    String robotId = in.text();
    if (!ArmLibrary.ids().contains(robotId)) {
      throw new MalformedBytes("its robot is not known here");
    }
    int framesPerSecond = in.upTo(Integer.MAX_VALUE);
    if (framesPerSecond != FrameTime.FRAMES_PER_SECOND) {
      throw new MalformedBytes(
          "it has " + framesPerSecond + " frames a second, must be " + FrameTime.FRAMES_PER_SECOND);
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
      throw new MalformedBytes("it has other columns than those of version " + VERSION);
    }
    ArmDescription model = ArmLibrary.load(robotId);
    return in.left() == 0 ? model : model.withCalibration(calibration(in.text()));
  }

  private static Calibration calibration(String text) throws MalformedBytes {
    try {
      return CalibrationFile.ofText(text);
    } catch (CalibrationTrouble e) {
      throw new MalformedBytes("its calibration cannot be read: " + e.getMessage());
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
