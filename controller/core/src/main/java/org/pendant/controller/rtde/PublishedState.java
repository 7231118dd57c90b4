package org.pendant.controller.rtde;

import java.util.Collection;
import java.util.Optional;
import java.util.function.Supplier;
import org.pendant.controller.box.Published;
import org.pendant.controller.quantity.PortImage;
import org.pendant.controller.state.ControllerState;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.Value;
import org.pendant.script.value.ValueKind;

/**
 * Published state reader: reads the newest snapshot for programs, exactly as clients get it.
 * Belongs to the thread of the frame loop.
 */
public final class PublishedState implements Published {
  private static final long UINT32 = 0xFFFF_FFFFL;

  private final Supplier<ControllerState> newest;

  /** Reads what {@code newest} gives. */
  public PublishedState(Supplier<ControllerState> newest) {
    this.newest = newest;
  }

  @Override
  public Optional<Value> field(String name) {
    return OutputFields.of(name).map(this::read);
  }

  private Value read(OutputField field) {
    ControllerState state = newest.get();
    return switch (field.type()) {
      case BOOL -> Value.of(number(field, state) != 0);
      case UINT8, INT32 -> Value.of((int) number(field, state));
      case UINT32 -> whole((long) number(field, state) & UINT32);
      case UINT64 -> whole((long) number(field, state));
      case DOUBLE -> Value.of(number(field, state));
      case VECTOR3D, VECTOR6D -> NumberList.of(field.quantity().numbers(state));
      case VECTOR6INT32, VECTOR6UINT32 ->
          NumberList.owning(field.quantity().numbers(state), field.count(), ValueKind.INT);
    };
  }

  private static double number(OutputField field, ControllerState state) {
    return field.quantity().getter().element(field.from()).applyAsDouble(state);
  }

  /** Scripts have ints of 32 bits with a sign; what does not fit is a float. */
  private static Value whole(long number) {
    return number == (int) number ? Value.of((int) number) : Value.of((double) number);
  }

  @Override
  public Collection<String> fieldNames() {
    return OutputFields.all().stream().map(OutputField::name).toList();
  }

  @Override
  public boolean takesInput(String name) {
    return InputFields.of(name).isPresent();
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
