package org.pendant.controller.eip;

import static org.pendant.controller.eip.AssemblyDataTexts.text;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import org.pendant.script.value.BoolValue;
import org.pendant.script.value.FloatValue;
import org.pendant.script.value.IntValue;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.StringValue;
import org.pendant.script.value.Value;

/**
 * Assembly field: a part of an assembly that has a label (manual 21.3.1 to 21.3.4). Bits are
 * counted from bit 0 of byte 0; buffers are little-endian and hold the whole assembly.
 */
public sealed interface AssemblyField {
  /** Its first bit. */
  long firstBit();

  /** The bit after its last one. */
  long endBit();

  /** Its value, which the caller owns. */
  Value read(ByteBuffer data);

  /** Changes it. */
  void write(ByteBuffer data, Value value) throws WrongFieldValue;

  /** Whether both cannot be defined in one assembly. Only bits may lie within numbers. */
  default boolean collidesWith(AssemblyField other) {
    boolean apart = endBit() <= other.firstBit() || other.endBit() <= firstBit();
    boolean shared =
        (this instanceof Bit && other.numeric()) || (numeric() && other instanceof Bit);
    return !apart && !shared;
  }

  private boolean numeric() {
    return this instanceof Scalar || this instanceof Numbers;
  }

  /** One number. */
  record Scalar(NumberType type, int offset) implements AssemblyField {
    @Override
    public long firstBit() {
      return (long) offset * Byte.SIZE;
    }

    @Override
    public long endBit() {
      return firstBit() + (long) type.bytes() * Byte.SIZE;
    }

    @Override
    public Value read(ByteBuffer data) {
      return type.value(type.read(data, offset));
    }

    @Override
    public void write(ByteBuffer data, Value value) throws WrongFieldValue {
      switch (value) {
        case IntValue number -> type.write(data, offset, number.value());
        case FloatValue number -> type.write(data, offset, number.value());
        default ->
            throw WrongFieldValue.wrongType(
                value.kind().described(), text("numberFor", type.text()));
      }
    }
  }

  /** An array of numbers; writing fewer makes the rest zero. */
  record Numbers(NumberType type, int offset, int length) implements AssemblyField {
    @Override
    public long firstBit() {
      return (long) offset * Byte.SIZE;
    }

    @Override
    public long endBit() {
      return firstBit() + (long) length * type.bytes() * Byte.SIZE;
    }

    @Override
    public Value read(ByteBuffer data) {
      double[] numbers = new double[length];
      for (int i = 0; i < length; i++) {
        numbers[i] = type.read(data, offset + i * type.bytes());
      }
      return NumberList.owning(numbers, length, type.kind());
    }

    @Override
    public void write(ByteBuffer data, Value value) throws WrongFieldValue {
      if (!(value instanceof NumberList list && list.elementKind().isNumber())) {
        throw WrongFieldValue.wrongType(value.kind().described(), text("numbersFor", type.text()));
      }
      if (list.length() > length) {
        throw WrongFieldValue.outOfRange(
            text("listOf", list.length()), text("mostNumbers", length));
      }
      for (int i = 0; i < length; i++) {
        type.write(data, offset + i * type.bytes(), i < list.length() ? list.numberAt(i) : 0);
      }
    }
  }

  /**
   * One bit of a byte, word or double word.
   *
   * @param offset of the byte, word or double word
   * @param bit 0 for its least significant bit
   */
  record Bit(int offset, int bit) implements AssemblyField {
    @Override
    public long firstBit() {
      return (long) offset * Byte.SIZE + bit;
    }

    @Override
    public long endBit() {
      return firstBit() + 1;
    }

    private int index() {
      return offset + bit / Byte.SIZE;
    }

    private int mask() {
      return 1 << bit % Byte.SIZE;
    }

    @Override
    public Value read(ByteBuffer data) {
      return Value.of((data.get(index()) & mask()) != 0);
    }

    @Override
    public void write(ByteBuffer data, Value value) throws WrongFieldValue {
      boolean set =
          switch (value) {
            case BoolValue bool -> bool.value();
            case IntValue number when number.value() == 0 || number.value() == 1 ->
                number.value() == 1;
            case IntValue number -> throw WrongFieldValue.outOfRange(number.text(), text("bit"));
            default ->
                throw WrongFieldValue.wrongType(value.kind().described(), text("boolForBit"));
          };
      int others = data.get(index()) & ~mask();
      data.put(index(), (byte) (set ? others | mask() : others));
    }
  }

  /** A text that ends with a zero byte unless it takes all of its place. */
  record Text(int offset, int length) implements AssemblyField {
    @Override
    public long firstBit() {
      return (long) offset * Byte.SIZE;
    }

    @Override
    public long endBit() {
      return firstBit() + (long) length * Byte.SIZE;
    }

    @Override
    public Value read(ByteBuffer data) {
      byte[] bytes = new byte[length];
      data.get(offset, bytes);
      int end = 0;
      while (end < length && bytes[end] != 0) {
        end++;
      }
      return new StringValue(new String(bytes, 0, end, StandardCharsets.ISO_8859_1));
    }

    @Override
    public void write(ByteBuffer data, Value value) throws WrongFieldValue {
      if (!(value instanceof StringValue text)) {
        throw WrongFieldValue.wrongType(value.kind().described(), AssemblyDataTexts.text("string"));
      }
      byte[] bytes = text.bytes().getBytes(StandardCharsets.ISO_8859_1);
      if (bytes.length > length) {
        throw WrongFieldValue.outOfRange(
            text("stringOf", bytes.length), text("mostCharacters", length));
      }
      data.put(offset, new byte[length]);
      data.put(offset, bytes);
    }
  }
}
