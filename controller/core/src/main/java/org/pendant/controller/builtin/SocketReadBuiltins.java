package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import java.util.Optional;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.external.ExternalSocket;
import org.pendant.controller.external.ReceivedBytes;
import org.pendant.controller.external.SocketRead;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.models.time.FrameTime;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Declaration;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/** Socket read builtins: reading from sockets (manual 18.55, 18.57 to 18.61). */
final class SocketReadBuiltins {
  /** Most values that one call reads. */
  private static final int MAX_VALUES = 30;

  private static final int INT_BYTES = 4;

  /** Computing time for a byte that is looked at. */
  private static final long NS_A_BYTE = 2;

  /** How long an answer to GET may take, s. */
  private static final double VARIABLE_TIMEOUT_S = 2;

  private SocketReadBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    declareNumbers(builtins);
    declareTexts(builtins);
  }

  private static void declareNumbers(Builtins<ControlBox> builtins) {
    builtins
        .declare("socket_get_var")
        .manual(SocketArguments.MODULE, "18.55")
        .doc(
            "Sends the line GET name and returns the int of the answer, the line name value. It is"
                + " 0 when there is no such line within 2 seconds.")
        .needs("name", Type.STRING)
        .takes(SocketArguments.NAME, Type.STRING, SocketArguments.DEFAULT_NAME)
        .returns(Type.INT)
        .physicalTime()
        .does(SocketReadBuiltins::variable);
    timed(
            builtins
                .declare("socket_read_ascii_float")
                .manual(SocketArguments.MODULE, "18.57")
                .doc(
                    "Reads up to 30 numbers written as (1.5, 2, -3e2). The list begins with how"
                        + " many were read; after a failure or the timeout that is 0 and the rest"
                        + " is nan.")
                .needs("number", Type.INT))
        .returns(Type.LIST)
        .does(call -> read(call, "socket_read_ascii_float", 1, new SocketRead.Floats(count(call))));
    timed(
            builtins
                .declare("socket_read_binary_integer")
                .manual(SocketArguments.MODULE, "18.58")
                .doc(
                    "Reads up to 30 ints of four bytes, the most significant first. The list"
                        + " begins with how many were read; after a failure or the timeout that is"
                        + " 0 and the rest is -1.")
                .needs("number", Type.INT))
        .returns(Type.LIST)
        .does(
            call ->
                read(
                    call,
                    "socket_read_binary_integer",
                    1,
                    new SocketRead.Binary(count(call), INT_BYTES)));
    timed(
            builtins
                .declare("socket_read_byte_list")
                .manual(SocketArguments.MODULE, "18.59")
                .doc(
                    "Reads up to 30 bytes, 0 to 255 each. The list begins with how many were read;"
                        + " after a failure or the timeout that is 0 and the rest is -1.")
                .needs("number", Type.INT))
        .returns(Type.LIST)
        .does(
            call -> read(call, "socket_read_byte_list", 1, new SocketRead.Binary(count(call), 1)));
  }

  private static void declareTexts(Builtins<ControlBox> builtins) {
    timed(
            builtins
                .declare("socket_read_line")
                .manual(SocketArguments.MODULE, "18.60")
                .doc(
                    "Reads a line without its end. It is empty after a failure or the timeout, or"
                        + " when the line has more than 1024 characters."))
        .deprecated("socket_read_string")
        .returns(Type.STRING)
        .does(
            call ->
                wait(
                    call,
                    "socket_read_line",
                    0,
                    new SocketRead.Line(),
                    SocketArguments.deadline(call, 1)));
    builtins
        .declare("socket_read_string")
        .manual(SocketArguments.MODULE, "18.61")
        .doc(
            "Reads a text of at most 1024 characters: all that has arrived, or what stands between"
                + " prefix and suffix. What comes before the prefix is dropped, what follows the"
                + " suffix stays for the next read. With interpret_escape, \\n, \\r and \\t in"
                + " both mean the characters. It is empty after a failure or the timeout; a"
                + " timeout of 0 or less waits for ever.")
        .takes(SocketArguments.NAME, Type.STRING, SocketArguments.DEFAULT_NAME)
        .takes("prefix", Type.STRING, Value.of(""))
        .takes("suffix", Type.STRING, Value.of(""))
        .takes("interpret_escape", Type.BOOL, Value.of(false))
        .takes(SocketArguments.TIMEOUT, Unit.SECOND, SocketArguments.DEFAULT_TIMEOUT_S)
        .returns(Type.STRING)
        .physicalTime()
        .does(SocketReadBuiltins::string);
  }

  private static Declaration<ControlBox> timed(Declaration<ControlBox> declaration) {
    return declaration
        .takes(SocketArguments.NAME, Type.STRING, SocketArguments.DEFAULT_NAME)
        .takes(SocketArguments.TIMEOUT, Unit.SECOND, SocketArguments.DEFAULT_TIMEOUT_S)
        .physicalTime();
  }

  private static int count(Call<ControlBox> call) throws ScriptError {
    return call.integer(0, 1, MAX_VALUES);
  }

  private static Outcome variable(Call<ControlBox> call) throws ScriptError {
    String name = call.text(0);
    SocketArguments.socket(call, "socket_get_var", 1)
        .ifPresent(each -> each.send(SocketBuiltins.bytes("GET " + name + "\n")));
    long deadline = call.frame() + FrameTime.framesFor(VARIABLE_TIMEOUT_S);
    return wait(call, "socket_get_var", 1, new SocketRead.Variable(name), deadline);
  }

  private static Outcome string(Call<ControlBox> call) throws ScriptError {
    boolean escapes = call.bool(3);
    SocketRead read = new SocketRead.Text(mark(call, 1, escapes), mark(call, 2, escapes));
    return wait(call, "socket_read_string", 0, read, SocketArguments.deadline(call, 4));
  }

  /** A prefix or suffix as it is looked for: without leading blanks. */
  private static String mark(Call<ControlBox> call, int index, boolean escapes) throws ScriptError {
    String text = call.text(index);
    int start = 0;
    while (start < text.length() && text.charAt(start) == ' ') {
      start++;
    }
    String mark = text.substring(start);
    if (escapes) {
      mark = mark.replace("\\n", "\n").replace("\\r", "\r").replace("\\t", "\t");
    }
    if (mark.length() > SocketRead.LONGEST) {
      throw call.refuse(index, text("mostCharacters", SocketRead.LONGEST));
    }
    return mark;
  }

  /** Reads from the socket that argument {@code index} names; the timeout follows it. */
  private static Outcome read(Call<ControlBox> call, String function, int index, SocketRead read)
      throws ScriptError {
    return wait(call, function, index, read, SocketArguments.deadline(call, index + 1));
  }

  /**
   * Answers with what is there already, or waits. What fails takes its frame, so that a loop over a
   * socket that is lost leaves time to others.
   */
  private static Outcome wait(
      Call<ControlBox> call, String function, int index, SocketRead read, long deadline)
      throws ScriptError {
    Optional<ExternalSocket> socket = SocketArguments.socket(call, function, index);
    if (socket.isEmpty()) {
      return SocketReadWait.notOpen(read);
    }
    ReceivedBytes received = socket.get().received();
    int before = received.length();
    Optional<Value> value = read.from(received);
    int lookedAt = Math.max(before - received.length(), Math.min(before, SocketRead.LONGEST));
    call.charge(lookedAt * NS_A_BYTE);
    return value.isPresent()
        ? call.answer(value.get())
        : new SocketReadWait(socket.get(), read, deadline);
  }
}
