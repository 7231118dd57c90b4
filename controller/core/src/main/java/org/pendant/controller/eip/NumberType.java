package org.pendant.controller.eip;

import java.nio.ByteBuffer;
import org.pendant.script.value.FloatValue;
import org.pendant.script.value.IntValue;
import org.pendant.script.value.Value;
import org.pendant.script.value.ValueKind;

/** Number type of an assembly's field (manual 21.3.1). */
public enum NumberType {
  UINT8("uint8", 1, 0, 0xFF),
  UINT16("uint16", 2, 0, 0xFFFF),
  INT16("int16", 2, Short.MIN_VALUE, Short.MAX_VALUE),
  INT32("int32", 4, Integer.MIN_VALUE, Integer.MAX_VALUE),
  FLOAT32("float32", 4, -Float.MAX_VALUE, Float.MAX_VALUE);

  private final String text;
  private final int bytes;
  private final double least;
  private final double most;

  NumberType(String text, int bytes, double least, double most) {
    this.text = text;
    this.bytes = bytes;
    this.least = least;
    this.most = most;
  }

  /** Its name in the names of methods. */
  public String text() {
    return text;
  }

  /** How many bytes a number takes. */
  public int bytes() {
    return bytes;
  }

  /** The kind of value that scripts get. */
  ValueKind kind() {
    return this == FLOAT32 ? ValueKind.FLOAT : ValueKind.INT;
  }

  Value value(double number) {
    return this == FLOAT32 ? new FloatValue(number) : new IntValue((int) number);
  }

  double read(ByteBuffer data, int offset) {
    return switch (this) {
      case UINT8 -> Byte.toUnsignedInt(data.get(offset));
      case UINT16 -> Short.toUnsignedInt(data.getShort(offset));
      case INT16 -> data.getShort(offset);
      case INT32 -> data.getInt(offset);
      case FLOAT32 -> data.getFloat(offset);
    };
  }

  /** Writes a number; a float without fraction counts as an integer. */
  void write(ByteBuffer data, int offset, double number) throws WrongFieldValue {
    if (!(number >= least && number <= most)) {
      throw WrongFieldValue.outOfRange(
          Value.of(number).text(),
          AssemblyDataTexts.text("rangeFor", Value.of(least).text(), Value.of(most).text(), text));
    }
    if (this != FLOAT32 && number != Math.rint(number)) {
      throw WrongFieldValue.wrongType(
          Value.of(number).text(), AssemblyDataTexts.text("intFor", text));
    }
    switch (this) {
      case UINT8 -> data.put(offset, (byte) (int) number);
      case UINT16, INT16 -> data.putShort(offset, (short) (int) number);
      case INT32 -> data.putInt(offset, (int) number);
      case FLOAT32 -> data.putFloat(offset, (float) number);
    }
  }
}
