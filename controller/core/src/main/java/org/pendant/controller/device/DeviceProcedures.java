package org.pendant.controller.device;

import static org.pendant.controller.device.DeviceTexts.text;

import java.util.List;
import java.util.Optional;
import org.pendant.controller.external.Pending;
import org.pendant.controller.external.RpcLink;
import org.pendant.script.value.NoneValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/** Device procedures: the link of a program to the devices that serve one port. */
record DeviceProcedures(List<CellDevice> devices) implements RpcLink {
  @Override
  public Pending connect() {
    return new AnsweredNow(NoneValue.NONE);
  }

  @Override
  public Pending call(String method, List<Value> arguments) throws ScriptError {
    return new AnsweredNow(call(devices, method, arguments));
  }

  /** What the first device answers that has such a procedure. */
  static Value call(List<CellDevice> devices, String method, List<Value> arguments)
      throws ScriptError {
    for (CellDevice each : devices) {
      Optional<Value> answer = each.call(method, arguments);
      if (answer.isPresent()) {
        return answer.get();
      }
    }
    throw new ScriptError(
        "no-such-procedure",
        text("noProcedure", String.join(", ", devices.stream().map(CellDevice::name).toList())));
  }

  @Override
  public void disconnect() {}

  @Override
  public void close() {}
}
