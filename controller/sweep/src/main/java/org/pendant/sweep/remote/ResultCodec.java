package org.pendant.sweep.remote;

import static org.pendant.sweep.remote.RemoteTexts.text;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.pendant.models.arm.Joints;
import org.pendant.sweep.plan.ParameterValue;
import org.pendant.sweep.plan.SweepVariant;
import org.pendant.sweep.run.JointLoads;
import org.pendant.sweep.run.LineTime;
import org.pendant.sweep.run.OutputChange;
import org.pendant.sweep.run.RunOutcome;
import org.pendant.sweep.run.SweepResult;

/**
 * Result codec: variants and results as bytes, for workers in other processes of the same build.
 * Numbers keep every bit. Big-endian; texts and lists begin with their length.
 */
public final class ResultCodec {
  /** Far above any text of a result. */
  private static final int MAX_TEXT_BYTES = 1 << 24;

  private static final int MAX_ITEMS = 1 << 20;

  private ResultCodec() {}

  /** Writes a variant. */
  public static void write(DataOutputStream out, SweepVariant variant) throws IOException {
    out.writeLong(variant.number());
    out.writeInt(variant.values().size());
    for (ParameterValue each : variant.values()) {
      writeText(out, each.text());
      out.writeDouble(each.number());
    }
  }

  /**
   * Reads a variant.
   *
   * @throws IOException if it is none
   */
  public static SweepVariant readVariant(DataInputStream in) throws IOException {
    long number = in.readLong();
    int size = readSize(in);
    List<ParameterValue> values = new ArrayList<>();
    for (int i = 0; i < size; i++) {
      values.add(new ParameterValue(readText(in), in.readDouble()));
    }
    return new SweepVariant(number, values);
  }

  /** Writes a result, without its variant, which the reader has. */
  public static void write(DataOutputStream out, SweepResult result) throws IOException {
    out.writeByte(result.outcome().ordinal());
    writeText(out, result.reason());
    out.writeInt(result.line());
    out.writeDouble(result.durationS());
    write(out, result.torque());
    write(out, result.speed());
    write(out, result.current());
    out.writeDouble(result.toolSpeedMPerS());
    out.writeDouble(result.toolSpeedShare());
    out.writeDouble(result.jointLimitRad());
    out.writeDouble(result.planeM());
    out.writeDouble(result.singularity());
    out.writeDouble(result.forceN());
    out.writeDouble(result.torqueNm());
    out.writeDouble(result.energyJ());
    out.writeInt(result.endTcpInBase().size());
    for (double each : result.endTcpInBase()) {
      out.writeDouble(each);
    }
    out.writeInt(result.lines().size());
    for (LineTime each : result.lines()) {
      out.writeInt(each.line());
      out.writeLong(each.frames());
    }
    out.writeInt(result.outputs().size());
    for (OutputChange each : result.outputs()) {
      writeText(out, each.signal());
      out.writeBoolean(each.level());
      out.writeDouble(each.timeS());
    }
    out.writeInt(result.variables().size());
    for (String each : result.variables()) {
      writeText(out, each);
    }
    out.writeLong(result.digest());
  }

  /**
   * Reads a result.
   *
   * @param variant of which it is
   * @throws IOException if it is none
   */
  public static SweepResult readResult(DataInputStream in, SweepVariant variant)
      throws IOException {
    int outcome = in.readUnsignedByte();
    if (outcome >= RunOutcome.values().length) {
      throw new IOException(text("wrongOutcome", outcome));
    }
    return new SweepResult(
        variant,
        RunOutcome.values()[outcome],
        readText(in),
        in.readInt(),
        in.readDouble(),
        readLoads(in),
        readLoads(in),
        readLoads(in),
        in.readDouble(),
        in.readDouble(),
        in.readDouble(),
        in.readDouble(),
        in.readDouble(),
        in.readDouble(),
        in.readDouble(),
        in.readDouble(),
        readList(in, DataInputStream::readDouble),
        readList(in, each -> new LineTime(each.readInt(), each.readLong())),
        readList(
            in, each -> new OutputChange(readText(each), each.readBoolean(), each.readDouble())),
        readList(in, ResultCodec::readText),
        in.readLong());
  }

  private static void write(DataOutputStream out, JointLoads loads) throws IOException {
    for (Joints each : List.of(loads.peak(), loads.rms(), loads.share())) {
      for (int i = 0; i < Joints.COUNT; i++) {
        out.writeDouble(each.get(i));
      }
    }
  }

  private static JointLoads readLoads(DataInputStream in) throws IOException {
    return new JointLoads(readJoints(in), readJoints(in), readJoints(in));
  }

  private static Joints readJoints(DataInputStream in) throws IOException {
    return new Joints(
        in.readDouble(),
        in.readDouble(),
        in.readDouble(),
        in.readDouble(),
        in.readDouble(),
        in.readDouble());
  }

  private static void writeText(DataOutputStream out, String text) throws IOException {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    out.writeInt(bytes.length);
    out.write(bytes);
  }

  private static String readText(DataInputStream in) throws IOException {
    int length = in.readInt();
    if (length < 0 || length > MAX_TEXT_BYTES) {
      throw new IOException(text("textTooLong", length));
    }
    byte[] bytes = in.readNBytes(length);
    if (bytes.length < length) {
      throw new IOException(text("textCut"));
    }
    return new String(bytes, StandardCharsets.UTF_8);
  }

  /** Reads one item of a list. */
  @FunctionalInterface
  private interface ItemReader<T> {
    T read(DataInputStream in) throws IOException;
  }

  private static <T> List<T> readList(DataInputStream in, ItemReader<T> reader) throws IOException {
    int size = readSize(in);
    List<T> items = new ArrayList<>();
    for (int i = 0; i < size; i++) {
      items.add(reader.read(in));
    }
    return items;
  }

  private static int readSize(DataInputStream in) throws IOException {
    int size = in.readInt();
    if (size < 0 || size > MAX_ITEMS) {
      throw new IOException(text("listTooLong", size));
    }
    return size;
  }
}
