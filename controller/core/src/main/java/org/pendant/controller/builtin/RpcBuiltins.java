package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import java.util.ArrayList;
import java.util.List;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.external.RpcLink;
import org.pendant.language.signature.Type;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.HandleValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/** Remote procedure calls (manual 8, 18.40). */
final class RpcBuiltins {
  private static final String XMLRPC = "xmlrpc";

  private RpcBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    builtins
        .declare("rpc_factory")
        .manual("interfaces", "18.40")
        .doc(
            "A handle by which functions of another computer are called as methods of any name."
                + " The type is \"xmlrpc\", the url http://host:port/path or host:port for a"
                + " stream of packets; it is an error when the server is not there.")
        .needs("type", Type.STRING)
        .needs("url", Type.STRING)
        .returns(Type.RPC_HANDLE)
        .physicalTime()
        .does(RpcBuiltins::factory);
    builtins
        .declareMethod(Type.RPC_HANDLE, "closeXMLRPCClientConnection")
        .manual("core", "8.1")
        .doc("Closes the connection to the server. A call after this opens another one.")
        .does(RpcBuiltins::close);
    builtins.declareAnyMethod(Type.RPC_HANDLE, RpcBuiltins::call);
  }

  private static Outcome factory(Call<ControlBox> call) throws ScriptError {
    if (!call.text(0).equals(XMLRPC)) {
      throw call.refuse(0, text("mustBeThat", XMLRPC));
    }
    try {
      int number = call.host().links().outside().openServer(call.text(1));
      Value handle = new HandleValue(Type.RPC_HANDLE, number, "");
      RpcLink server = call.host().links().outside().server(number);
      return new PendingWait("rpc_factory: " + call.text(1), server.connect(), result -> handle);
    } catch (ScriptError e) {
      throw call.failure(e.code(), e.getMessage());
    }
  }

  private static Outcome close(Call<ControlBox> call) throws ScriptError {
    call.program().reachesOutside();
    call.host().links().outside().server(handle(call).id()).disconnect();
    return call.answer();
  }

  private static Outcome call(Call<ControlBox> call, String method, int count) throws ScriptError {
    call.program().reachesOutside();
    HandleValue handle = handle(call);
    String name = handle.member(method).path();
    List<Value> arguments = new ArrayList<>(count);
    for (int i = 1; i <= count; i++) {
      arguments.add(call.value(i).copy());
    }
    try {
      RpcLink server = call.host().links().outside().server(handle.id());
      return new PendingWait(name, server.call(name, arguments), result -> result);
    } catch (ScriptError e) {
      throw new ScriptError(e.code(), name + ": " + e.getMessage());
    }
  }

  private static HandleValue handle(Call<ControlBox> call) throws ScriptError {
    if (call.value(0) instanceof HandleValue handle) {
      return handle;
    }
    throw call.wrongKind(0, text("rpcHandle"));
  }
}
