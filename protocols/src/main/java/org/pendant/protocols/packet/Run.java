package org.pendant.protocols.packet;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;

/**
 * Run of numbers of one type that follow each other where they come from, and stand at equal
 * distances in the packet.
 *
 * @param from index of the first among all numbers
 * @param count how many they are
 * @param at where the first begins
 * @param stride bytes from one to the next
 */
record Run(WireType type, int from, int count, int at, int stride) {
  // a view of the bytes costs half of what a byte buffer does where C1 alone compiles
  private static final VarHandle LONG =
      MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.BIG_ENDIAN);
  private static final VarHandle INT =
      MethodHandles.byteArrayViewVarHandle(int[].class, ByteOrder.BIG_ENDIAN);
  private static final VarHandle SHORT =
      MethodHandles.byteArrayViewVarHandle(short[].class, ByteOrder.BIG_ENDIAN);
  private static final VarHandle LITTLE_LONG =
      MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.LITTLE_ENDIAN);
  private static final VarHandle LITTLE_INT =
      MethodHandles.byteArrayViewVarHandle(int[].class, ByteOrder.LITTLE_ENDIAN);
  private static final VarHandle LITTLE_SHORT =
      MethodHandles.byteArrayViewVarHandle(short[].class, ByteOrder.LITTLE_ENDIAN);

  /** Whether another number could be the next one. */
  boolean continuesWith(WireType other, int index, int place) {
    return other == type
        && index == from + count
        && (count == 1 ? place > at : place == at + count * stride);
  }

  /** With that number. */
  Run with(int place) {
    return new Run(type, from, count + 1, at, count == 1 ? place - at : stride);
  }

  /** Puts the numbers into a packet. */
  void put(double[] numbers, byte[] packet, boolean little) {
    int place = at;
    int end = from + count;
    switch (type) {
      case INT8 -> {
        for (int i = from; i < end; i++, place += stride) {
          packet[place] = (byte) (long) numbers[i];
        }
      }
      case INT16 -> {
        for (int i = from; i < end; i++, place += stride) {
          putShort(packet, place, (short) (long) numbers[i], little);
        }
      }
      case INT32 -> {
        for (int i = from; i < end; i++, place += stride) {
          putInt(packet, place, (int) (long) numbers[i], little);
        }
      }
      case INT64 -> {
        for (int i = from; i < end; i++, place += stride) {
          putLong(packet, place, (long) numbers[i], little);
        }
      }
      case FLOAT32 -> {
        for (int i = from; i < end; i++, place += stride) {
          putInt(packet, place, Float.floatToRawIntBits((float) numbers[i]), little);
        }
      }
      case FLOAT64 -> {
        for (int i = from; i < end; i++, place += stride) {
          putLong(packet, place, Double.doubleToRawLongBits(numbers[i]), little);
        }
      }
    }
  }

  private static void putShort(byte[] packet, int place, short value, boolean little) {
    if (little) {
      LITTLE_SHORT.set(packet, place, value);
    } else {
      SHORT.set(packet, place, value);
    }
  }

  private static void putInt(byte[] packet, int place, int value, boolean little) {
    if (little) {
      LITTLE_INT.set(packet, place, value);
    } else {
      INT.set(packet, place, value);
    }
  }

  private static void putLong(byte[] packet, int place, long value, boolean little) {
    if (little) {
      LITTLE_LONG.set(packet, place, value);
    } else {
      LONG.set(packet, place, value);
    }
  }
}
