package org.pendant.controller;

import java.util.List;
import java.util.Optional;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.box.WorldCommand;
import org.pendant.controller.command.CommandHandler;
import org.pendant.controller.command.Reply;
import org.pendant.controller.world.Vector3;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.pose.Wrench;
import org.pendant.script.value.Value;

/** Handler of what is done to the simulated world. */
final class WorldCommandHandler implements CommandHandler<WorldCommand> {
  private final ControlBox box;

  WorldCommandHandler(ControlBox box) {
    this.box = box;
  }

  @Override
  public Class<WorldCommand> family() {
    return WorldCommand.class;
  }

  @Override
  public Reply carryOut(WorldCommand command) {
    switch (command) {
      case WorldCommand.PushTool(Wrench wrenchAtTcpInBase) ->
          box.arm().world().apply(wrenchAtTcpInBase);
      case WorldCommand.PushLink(int link, Vector3 pointInLinkM, Vector3 forceInBaseN) ->
          box.arm().world().grip().push(link, pointInLinkM, forceInBaseN);
      case WorldCommand.PullLink(int link, Vector3 pointInLinkM, Vector3 placeInBaseM) ->
          box.arm().world().grip().pull(link, pointInLinkM, placeInBaseM);
      case WorldCommand.CarryObject(String object, Vector3 pointInBaseM, Vector3 placeInBaseM) ->
          box.arm().world().carry(object, pointInBaseM, placeInBaseM);
      case WorldCommand.LetGo _ -> {
        box.arm().world().grip().letGo();
        box.arm().world().putDown();
      }
      case WorldCommand.AttachLoad(Optional<Payload> load) ->
          load.ifPresentOrElse(box.flange()::attachLoad, box.flange()::followDeclaredPayload);
      case WorldCommand.RunEncoder(int index, double ticksPerS) ->
          box.offsets().encoders().get(index).run(ticksPerS);
      case WorldCommand.PutPart(String gripper, double widthM) ->
          box.links().devices().putPart(gripper, widthM);
      case WorldCommand.SetSignal(String signal, int value) ->
          box.links().devices().set(signal, value);
      case WorldCommand.TellDevice(int port, long connection, String bytes) -> {
        return new Reply.Told(box.links().devices().hear(port, connection, bytes));
      }
      case WorldCommand.CallDevice(int port, String method, List<Value> arguments) -> {
        return new Reply.Returned(box.links().devices().call(port, method, arguments));
      }
      case WorldCommand.LeaveDevice(int port, long connection) ->
          box.links().devices().leave(port, connection);
    }
    return Reply.done();
  }
}
