package org.pendant.models.arm;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.zip.CRC32;

/**
 * Calibration of one arm: how it is made, where that differs from its model.
 *
 * @param geometry where its joints are
 * @param jointChecksums six numbers by which a controller tells arms apart
 * @param status what the controller has done with it
 */
public record Calibration(LinkGeometry geometry, List<Integer> jointChecksums, Status status) {
  /** An arm exactly as its model says; controllers that know no more have these checksums. */
  public static final Calibration NONE =
      new Calibration(DhDeltas.NONE, Collections.nCopies(Joints.COUNT, -1), Status.NOT_INITIALISED);

  /** What a controller has done with a calibration. */
  public enum Status {
    NOT_INITIALISED(0),
    NOT_LINEARISED(1),
    LINEARISED(2);

    private final int number;

    Status(int number) {
      this.number = number;
    }

    /** The number that controllers have for it. */
    public int number() {
      return number;
    }
  }

  /**
   * Checks the count of checksums and copies them.
   *
   * @throws IllegalArgumentException if there are not six
   */
  public Calibration {
    jointChecksums = List.copyOf(jointChecksums);
    if (jointChecksums.size() != Joints.COUNT) {
      throw new IllegalArgumentException(
          "calibration: has " + jointChecksums.size() + " checksums, must have " + Joints.COUNT);
    }
  }

  /** A calibration of which no checksums are known; some are made from its numbers. */
  public static Calibration of(LinkGeometry geometry) {
    if (geometry.equals(DhDeltas.NONE)) {
      return NONE;
    }
    List<Integer> checksums = new ArrayList<>();
    for (int i = 0; i < Joints.COUNT; i++) {
      checksums.add(
          switch (geometry) {
            case DhDeltas deltas ->
                checksum(
                    deltas.thetaRad().get(i),
                    deltas.aM().get(i),
                    deltas.dM().get(i),
                    deltas.alphaRad().get(i));
            case LinkFrames frames -> checksum(frames.frames().get(i));
          });
    }
    return new Calibration(geometry, checksums, Status.LINEARISED);
  }

  private static int checksum(LinkFrame frame) {
    return checksum(
        frame.xM(), frame.yM(), frame.zM(), frame.rollRad(), frame.pitchRad(), frame.yawRad());
  }

  private static int checksum(double... numbers) {
    ByteBuffer bytes = ByteBuffer.allocate(numbers.length * Double.BYTES);
    for (double number : numbers) {
      bytes.putDouble(number);
    }
    CRC32 checksum = new CRC32();
    checksum.update(bytes.array());
    return (int) checksum.getValue();
  }

  /** True if the arm is exactly as its model says. */
  public boolean isNominal() {
    return geometry.equals(DhDeltas.NONE);
  }
}
