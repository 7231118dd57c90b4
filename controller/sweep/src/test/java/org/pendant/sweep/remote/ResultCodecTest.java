package org.pendant.sweep.remote;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.pendant.models.arm.Joints;
import org.pendant.sweep.plan.ParameterValue;
import org.pendant.sweep.plan.SweepVariant;
import org.pendant.sweep.run.JointLoads;
import org.pendant.sweep.run.LineTime;
import org.pendant.sweep.run.OutputChange;
import org.pendant.sweep.run.RunOutcome;
import org.pendant.sweep.run.SweepResult;
import org.pendant.sweep.table.SomeResults;

final class ResultCodecTest {
  private static final SweepVariant VARIANT =
      new SweepVariant(7, List.of(ParameterValue.of(0.25), ParameterValue.of("p[é, 1]")));

  /** What is written somewhere. */
  @FunctionalInterface
  private interface Writing {
    void to(DataOutputStream out) throws IOException;
  }

  private static byte[] bytes(Writing writing) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    writing.to(new DataOutputStream(bytes));
    return bytes.toByteArray();
  }

  private static DataInputStream in(byte[] bytes) {
    return new DataInputStream(new ByteArrayInputStream(bytes));
  }

  @Test
  void randomResultsComeBackWithEveryBit() throws IOException {
    for (long seed = 0; seed < 1000; seed++) {
      SweepResult result = some(new Random(seed));
      byte[] written = bytes(out -> ResultCodec.write(out, result));
      assertEquals(result, ResultCodec.readResult(in(written), VARIANT), "seed " + seed);
    }
  }

  @Test
  void variantComesBack() throws IOException {
    byte[] written = bytes(out -> ResultCodec.write(out, VARIANT));
    assertEquals(VARIANT, ResultCodec.readVariant(in(written)));
  }

  @Test
  void whatIsCutAnywhereIsRefused() throws IOException {
    SweepResult result = SomeResults.of(VARIANT);
    byte[] whole = bytes(out -> ResultCodec.write(out, result));
    byte[] variant = bytes(out -> ResultCodec.write(out, VARIANT));
    for (int length = 0; length < whole.length; length++) {
      byte[] cut = Arrays.copyOf(whole, length);
      assertThrows(IOException.class, () -> ResultCodec.readResult(in(cut), VARIANT));
    }
    for (int length = 0; length < variant.length; length++) {
      byte[] cut = Arrays.copyOf(variant, length);
      assertThrows(IOException.class, () -> ResultCodec.readVariant(in(cut)));
    }
  }

  @Test
  void absurdLengthsAndOutcomesAreRefusedBeforeAnythingIsKeptForThem() throws IOException {
    byte[] manyValues =
        bytes(
            out -> {
              out.writeLong(7);
              out.writeInt(Integer.MAX_VALUE);
            });
    byte[] longText =
        bytes(
            out -> {
              out.writeByte(0);
              out.writeInt(-1);
            });
    byte[] outcome = bytes(out -> out.writeByte(RunOutcome.values().length));
    assertThrows(IOException.class, () -> ResultCodec.readVariant(in(manyValues)));
    assertThrows(IOException.class, () -> ResultCodec.readResult(in(longText), VARIANT));
    assertThrows(IOException.class, () -> ResultCodec.readResult(in(outcome), VARIANT));
  }

  private static SweepResult some(Random random) {
    Supplier<Double> number = () -> Double.longBitsToDouble(random.nextLong());
    return new SweepResult(
        VARIANT,
        RunOutcome.values()[random.nextInt(RunOutcome.values().length)],
        text(random),
        random.nextInt(),
        number.get(),
        loads(number),
        loads(number),
        loads(number),
        number.get(),
        number.get(),
        number.get(),
        number.get(),
        number.get(),
        number.get(),
        number.get(),
        number.get(),
        Stream.generate(number).limit(3).toList(),
        Stream.generate(() -> new LineTime(random.nextInt(), random.nextLong()))
            .limit(random.nextInt(4))
            .toList(),
        Stream.generate(() -> new OutputChange(text(random), random.nextBoolean(), number.get()))
            .limit(random.nextInt(4))
            .toList(),
        Stream.generate(() -> text(random)).limit(random.nextInt(4)).toList(),
        random.nextLong());
  }

  private static String text(Random random) {
    return random
        .ints(random.nextInt(9), 0, Character.MAX_CODE_POINT + 1)
        .filter(each -> each < Character.MIN_SURROGATE || each > Character.MAX_SURROGATE)
        .collect(StringBuilder::new, StringBuilder::appendCodePoint, StringBuilder::append)
        .toString();
  }

  private static JointLoads loads(Supplier<Double> number) {
    return new JointLoads(joints(number), joints(number), joints(number));
  }

  private static Joints joints(Supplier<Double> number) {
    return Joints.of(
        number.get(), number.get(), number.get(), number.get(), number.get(), number.get());
  }
}
