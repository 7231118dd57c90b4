package org.pendant.controller.rtde;

import java.nio.ByteBuffer;
import java.util.Collection;
import java.util.Optional;
import java.util.function.Supplier;
import org.pendant.controller.box.Published;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.PortImage;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.Value;
import org.pendant.script.value.ValueKind;

/**
 * Reads the newest snapshot for programs, exactly as clients get it. Belongs to the thread of the
 * frame loop.
 */
public final class PublishedState implements Published {
  private static final long UINT32 = 0xFFFF_FFFFL;

  private final Supplier<ControllerState> newest;
  private final ByteBuffer value = ByteBuffer.allocate(FieldType.VECTOR6D.bytes());

  /** Reads what {@code newest} gives. */
  public PublishedState(Supplier<ControllerState> newest) {
    this.newest = newest;
  }

  @Override
  public Optional<Value> field(String name) {
    return OutputFields.of(name).map(this::read);
  }

  private Value read(OutputField field) {
    value.clear();
    field.encoder().put(newest.get(), value);
    value.flip();
    return switch (field.type()) {
      case BOOL -> Value.of(value.get() != 0);
      case UINT8 -> Value.of(Byte.toUnsignedInt(value.get()));
      case UINT32 -> whole(value.getInt() & UINT32);
      case UINT64 -> whole(value.getLong());
      case INT32 -> Value.of(value.getInt());
      case DOUBLE -> Value.of(value.getDouble());
      case VECTOR3D, VECTOR6D -> floats();
      case VECTOR6INT32, VECTOR6UINT32 -> ints();
    };
  }

  /** Scripts have ints of 32 bits with a sign; what does not fit is a float. */
  private static Value whole(long number) {
    return number == (int) number ? Value.of((int) number) : Value.of((double) number);
  }

  private Value floats() {
    double[] numbers = new double[value.remaining() / Double.BYTES];
    value.asDoubleBuffer().get(numbers);
    return NumberList.of(numbers);
  }

  private Value ints() {
    double[] numbers = new double[value.remaining() / Integer.BYTES];
    for (int i = 0; i < numbers.length; i++) {
      numbers[i] = value.getInt();
    }
    return NumberList.owning(numbers, numbers.length, ValueKind.INT);
  }

  @Override
  public Collection<String> fieldNames() {
    return OutputFields.all().stream().map(OutputField::name).toList();
  }

  @Override
  public Optional<Integer> portRegister(int address) {
    return PortImage.register(address, newest.get());
  }

  @Override
  public Optional<Boolean> portBit(int address) {
    return PortImage.bit(address, newest.get());
  }
}
