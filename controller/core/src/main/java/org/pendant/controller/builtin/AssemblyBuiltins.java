package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import java.util.ArrayList;
import java.util.List;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.eip.AssemblyField;
import org.pendant.controller.eip.AssemblyHandle;
import org.pendant.controller.eip.NumberType;
import org.pendant.controller.io.WatchdogAction;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Declaration;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.HandleValue;
import org.pendant.script.value.ListValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.StringValue;
import org.pendant.script.value.StructValue;
import org.pendant.script.value.Value;
import org.pendant.script.value.ValueKind;

/** EtherNet/IP builtins: data that programs exchange with a scanner (manual 21). */
final class AssemblyBuiltins {
  private static final String MODULE = "eip";
  private static final double MAX_WATCHDOG_HZ = 10;
  private static final int LARGEST = 0xFFFF;

  private AssemblyBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    factory(builtins, "eip_reader_factory", "21.2.1")
        .doc(
            "A handle by which data are read that a scanner sends. The name is the number of the"
                + " assembly instance, which must exist with this size in bytes.")
        .does(call -> open(call, true));
    factory(builtins, "eip_writer_factory", "21.2.2")
        .doc(
            "A handle by which data are written that a scanner gets. The name is the number of the"
                + " assembly instance, which must exist with this size in bytes.")
        .does(call -> open(call, false));
    declareLayout(builtins);
    declareAccess(builtins);
    declareWatchdog(builtins);
    method(builtins, "close", "21.3.11")
        .doc("Closes the handle; its labels and its watchdog go away, the data stay.")
        .does(
            call -> {
              handle(call).close();
              return call.answer();
            });
  }

  private static Declaration<ControlBox> factory(
      Builtins<ControlBox> builtins, String name, String section) {
    return builtins
        .declare(name)
        .manual(MODULE, section)
        .needs("instance_name", Type.STRING)
        .needs("data_size", Type.INT)
        .returns(Type.EIP_HANDLE);
  }

  private static Declaration<ControlBox> method(
      Builtins<ControlBox> builtins, String name, String section) {
    return builtins.declareMethod(Type.EIP_HANDLE, name).manual(MODULE, section);
  }

  private static void declareLayout(Builtins<ControlBox> builtins) {
    for (NumberType type : NumberType.values()) {
      method(builtins, "define_" + type.text(), "21.3.1")
          .doc(
              "Gives a label to the "
                  + type.text()
                  + " at byte offset of the assembly. Labels must not overlap, except numbers and"
                  + " bits.")
          .needs("offset", Type.INT)
          .needs("data_name", Type.STRING)
          .does(call -> define(call, 2, new AssemblyField.Scalar(type, offset(call))));
      method(builtins, "define_" + type.text() + "_array", "21.3.3")
          .doc(
              "Gives a label to an array of "
                  + type.text()
                  + " that begins at byte offset of the assembly. Labels must not overlap, except"
                  + " numbers and bits.")
          .needs("offset", Type.INT)
          .needs("length", Type.INT)
          .needs("data_name", Type.STRING)
          .does(
              call -> define(call, 3, new AssemblyField.Numbers(type, offset(call), length(call))));
    }
    method(builtins, "define_bit", "21.3.2")
        .doc(
            "Gives a label to a bit of the byte, word or double word at byte offset of the"
                + " assembly. bitfield_width is 1, 2 or 4 bytes; bit 0 is the least significant.")
        .needs("offset", Type.INT)
        .needs("bit_number", Type.INT)
        .needs("data_name", Type.STRING)
        .takes("bitfield_width", Unit.NONE, 1)
        .does(AssemblyBuiltins::defineBit);
    method(builtins, "define_string", "21.3.4")
        .doc(
            "Gives a label to a text that begins at byte offset of the assembly. A text shorter"
                + " than length ends with a zero byte.")
        .needs("offset", Type.INT)
        .needs("length", Type.INT)
        .needs("data_name", Type.STRING)
        .does(call -> define(call, 3, new AssemblyField.Text(offset(call), length(call))));
  }

  private static void declareAccess(Builtins<ControlBox> builtins) {
    method(builtins, "read", "21.3.5")
        .doc(
            "The newest data that the scanner has sent. One label gives its value, a list of labels"
                + " a struct with members of these names.")
        .needs("data_names", Type.ANY)
        .returns(Type.ANY)
        .does(AssemblyBuiltins::read);
    method(builtins, "write", "21.3.6")
        .doc(
            "Writes the members of a struct to the labels of their names, all at once. A list"
                + " shorter than its array makes the rest zero; a value out of range is an error.")
        .needs("data_struct", Type.STRUCT)
        .does(
            call -> {
              AssemblyHandle handle = handle(call);
              StructValue values = call.struct(1);
              return done(call, () -> handle.write(values));
            });
    method(builtins, "clear", "21.3.7")
        .doc("Makes all bytes of the assembly zero.")
        .does(
            call -> {
              AssemblyHandle handle = handle(call);
              return done(call, handle::clear);
            });
  }

  private static void declareWatchdog(Builtins<ControlBox> builtins) {
    method(builtins, "set_watchdog", "21.3.8")
        .doc(
            "Watches from now on that the scanner sends at least this often. action is 0 for a line"
                + " in the log, 1 for a protective stop that pauses the program, 2 for one that"
                + " ends it. Only for handles that read.")
        .needs("frequency", Unit.HERTZ)
        .needs("action", Type.INT)
        .does(AssemblyBuiltins::setWatchdog);
    method(builtins, "start_watchdog", "21.3.9")
        .doc("Resumes watching after stop_watchdog. It is an error when none is set.")
        .does(
            call -> {
              AssemblyHandle handle = handle(call);
              return done(call, () -> handle.startWatchdog(call.host().clock().timeS()));
            });
    method(builtins, "stop_watchdog", "21.3.10")
        .doc("Watches no longer, until start_watchdog. It is an error when none is set.")
        .does(
            call -> {
              AssemblyHandle handle = handle(call);
              return done(call, handle::stopWatchdog);
            });
  }

  /** What may refuse; the name of the function comes in front of the reason. */
  @FunctionalInterface
  private interface Work {
    void run() throws ScriptError;
  }

  private static Outcome done(Call<ControlBox> call, Work work) throws ScriptError {
    try {
      work.run();
    } catch (ScriptError e) {
      throw call.failure(e.code(), e.getMessage());
    }
    return call.answer();
  }

  private static Outcome open(Call<ControlBox> call, boolean reading) throws ScriptError {
    String name = call.text(0);
    if (!name.matches("[0-9]{1,5}")) {
      throw call.refuse(0, text("assemblyNumber"));
    }
    int bytes = call.integer(1, 1, LARGEST);
    try {
      int number = call.host().links().assemblies().open(reading, Integer.parseInt(name), bytes);
      return call.answer(new HandleValue(Type.EIP_HANDLE, number, ""));
    } catch (ScriptError e) {
      throw call.failure(e.code(), e.getMessage());
    }
  }

  private static AssemblyHandle handle(Call<ControlBox> call) throws ScriptError {
    // a look-ahead must not change anything
    call.program().reachesOutside();
    if (!(call.value(0) instanceof HandleValue handle)) {
      throw call.wrongKind(0, text("assemblyHandle"));
    }
    try {
      return call.host().links().assemblies().handle(handle.id());
    } catch (ScriptError e) {
      throw call.failure(e.code(), e.getMessage());
    }
  }

  private static int offset(Call<ControlBox> call) throws ScriptError {
    return call.integer(1, 0, LARGEST);
  }

  private static int length(Call<ControlBox> call) throws ScriptError {
    return call.integer(2, 1, LARGEST);
  }

  private static Outcome define(Call<ControlBox> call, int index, AssemblyField field)
      throws ScriptError {
    AssemblyHandle handle = handle(call);
    String label = call.text(index);
    return done(call, () -> handle.define(label, field));
  }

  private static Outcome defineBit(Call<ControlBox> call) throws ScriptError {
    int width = call.given(4) ? call.integer(4) : 1;
    if (width != 1 && width != 2 && width != 4) {
      throw call.refuse(4, text("bitWidth"));
    }
    int bit = call.integer(2, 0, width * Byte.SIZE - 1);
    return define(call, 3, new AssemblyField.Bit(offset(call), bit));
  }

  private static Outcome read(Call<ControlBox> call) throws ScriptError {
    AssemblyHandle handle = handle(call);
    if (call.value(1) instanceof StringValue label) {
      return answer(call, () -> handle.read(label.bytes()));
    }
    List<String> labels = labels(call);
    return answer(call, () -> handle.read(labels));
  }

  /** Something that may refuse. */
  @FunctionalInterface
  private interface Reading {
    Value get() throws ScriptError;
  }

  private static Outcome answer(Call<ControlBox> call, Reading reading) throws ScriptError {
    try {
      return call.answer(reading.get());
    } catch (ScriptError e) {
      throw call.failure(e.code(), e.getMessage());
    }
  }

  private static List<String> labels(Call<ControlBox> call) throws ScriptError {
    if (!(call.value(1) instanceof ListValue list)
        || list.length() == 0
        || list.elementKind() != ValueKind.STRING) {
      throw call.wrongKind(1, text("stringOrStrings"));
    }
    List<String> labels = new ArrayList<>(list.length());
    for (int i = 0; i < list.length(); i++) {
      labels.add(list.get(i) instanceof StringValue label ? label.bytes() : "");
    }
    return labels;
  }

  private static Outcome setWatchdog(Call<ControlBox> call) throws ScriptError {
    double leastHz = call.number(1);
    if (!(leastHz > 0 && leastHz <= MAX_WATCHDOG_HZ)) {
      throw call.refuse(1, text("watchdogHz"));
    }
    WatchdogAction action = action(call);
    AssemblyHandle handle = handle(call);
    return done(call, () -> handle.setWatchdog(leastHz, action, call.host().clock().timeS()));
  }

  private static WatchdogAction action(Call<ControlBox> call) throws ScriptError {
    return switch (call.integer(2, 0, 2)) {
      case 0 -> WatchdogAction.IGNORE;
      case 1 -> WatchdogAction.PAUSE;
      default -> WatchdogAction.STOP;
    };
  }
}
