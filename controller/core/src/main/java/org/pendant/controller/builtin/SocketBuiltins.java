package org.pendant.controller.builtin;

import java.nio.charset.StandardCharsets;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.external.ExternalSocket;
import org.pendant.language.signature.Type;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.ScriptError;

/** Socket builtins: opening, closing and sending (manual 18.54, 18.56, 18.62 to 18.66). */
final class SocketBuiltins {
  private static final int MAX_PORT = 65_535;
  private static final int MAX_BYTE = 255;

  private SocketBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    declareConnection(builtins);
    declareNumbers(builtins);
    declareTexts(builtins);
  }

  private static void declareConnection(Builtins<ControlBox> builtins) {
    builtins
        .declare("socket_open")
        .manual(SocketArguments.MODULE, "18.56")
        .doc(
            "Connects to a TCP server and tells whether that succeeded within 2 seconds. All"
                + " threads share a socket by its name; one that is open already is closed first.")
        .needs("address", Type.STRING)
        .needs("port", Type.INT)
        .takes(SocketArguments.NAME, Type.STRING, SocketArguments.DEFAULT_NAME)
        .returns(Type.BOOL)
        .physicalTime()
        .does(SocketBuiltins::open);
    builtins
        .declare("socket_close")
        .manual(SocketArguments.MODULE, "18.54")
        .doc("Closes a socket, once everything has gone out. The end of the program does so too.")
        .takes(SocketArguments.NAME, Type.STRING, SocketArguments.DEFAULT_NAME)
        .does(SocketBuiltins::close);
  }

  private static void declareNumbers(Builtins<ControlBox> builtins) {
    builtins
        .declare("socket_send_byte")
        .manual(SocketArguments.MODULE, "18.62")
        .doc("Sends a byte, 0 to 255, and tells whether the socket took it.")
        .effect(Effect.TELLS)
        .needs("value", Type.INT)
        .takes(SocketArguments.NAME, Type.STRING, SocketArguments.DEFAULT_NAME)
        .returns(Type.BOOL)
        .does(call -> send(call, "socket_send_byte", 1, (byte) call.integer(0, 0, MAX_BYTE)));
    builtins
        .declare("socket_send_int")
        .manual(SocketArguments.MODULE, "18.63")
        .doc(
            "Sends an int as four bytes, the most significant first, and tells whether the socket"
                + " took it.")
        .effect(Effect.TELLS)
        .needs("value", Type.INT)
        .takes(SocketArguments.NAME, Type.STRING, SocketArguments.DEFAULT_NAME)
        .returns(Type.BOOL)
        .does(SocketBuiltins::sendInt);
    builtins
        .declare("socket_set_var")
        .manual(SocketArguments.MODULE, "18.66")
        .doc("Sends the line SET name value, with an int.")
        .effect(Effect.TELLS)
        .needs("name", Type.STRING)
        .needs("value", Type.INT)
        .takes(SocketArguments.NAME, Type.STRING, SocketArguments.DEFAULT_NAME)
        .does(SocketBuiltins::setVariable);
  }

  private static void declareTexts(Builtins<ControlBox> builtins) {
    builtins
        .declare("socket_send_line")
        .manual(SocketArguments.MODULE, "18.64")
        .doc(
            "Sends a text and a newline, and tells whether the socket took them. Other values are"
                + " sent as to_str writes them.")
        .effect(Effect.TELLS)
        .needs("str", Type.ANY)
        .takes(SocketArguments.NAME, Type.STRING, SocketArguments.DEFAULT_NAME)
        .returns(Type.BOOL)
        .does(call -> sendText(call, "socket_send_line", "\n"));
    builtins
        .declare("socket_send_string")
        .manual(SocketArguments.MODULE, "18.65")
        .doc(
            "Sends a text, and tells whether the socket took it. Other values are sent as to_str"
                + " writes them.")
        .effect(Effect.TELLS)
        .needs("str", Type.ANY)
        .takes(SocketArguments.NAME, Type.STRING, SocketArguments.DEFAULT_NAME)
        .returns(Type.BOOL)
        .does(call -> sendText(call, "socket_send_string", ""));
  }

  private static Outcome sendText(Call<ControlBox> call, String function, String end)
      throws ScriptError {
    return call.withText(text -> send(call, function, 1, bytes(text + end)), 0);
  }

  private static Outcome open(Call<ControlBox> call) throws ScriptError {
    String host = call.text(0);
    int port = call.integer(1, 1, MAX_PORT);
    String name = call.text(2);
    ExternalSocket socket;
    try {
      socket = call.host().links().outside().open(name, host, port);
    } catch (ScriptError e) {
      throw call.failure(e.code(), e.getMessage());
    }
    return new SocketOpenWait(call.host(), name, socket, host, port, call.frame());
  }

  private static Outcome close(Call<ControlBox> call) throws ScriptError {
    call.program().reachesOutside();
    call.host().links().outside().close(call.text(0));
    return call.answer();
  }

  private static Outcome sendInt(Call<ControlBox> call) throws ScriptError {
    int value = call.integer(0);
    return send(
        call,
        "socket_send_int",
        1,
        (byte) (value >> 24),
        (byte) (value >> 16),
        (byte) (value >> 8),
        (byte) value);
  }

  private static Outcome setVariable(Call<ControlBox> call) throws ScriptError {
    String line = "SET " + call.text(0) + " " + call.integer(1) + "\n";
    send(call, "socket_set_var", 2, bytes(line));
    return call.answer();
  }

  /** Sends by the socket that argument {@code index} names. */
  private static Outcome send(Call<ControlBox> call, String function, int index, byte... bytes)
      throws ScriptError {
    call.program().reachesOutside();
    call.charge(bytes.length);
    return call.answer(
        SocketArguments.socket(call, function, index).filter(each -> each.send(bytes)).isPresent());
  }

  static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.ISO_8859_1);
  }
}
