package org.pendant.controller.device;

import static org.pendant.controller.device.DeviceTexts.text;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.pendant.controller.device.camera.CameraLines;
import org.pendant.controller.device.camera.CameraProcedures;
import org.pendant.controller.device.camera.PartCamera;
import org.pendant.controller.external.DeviceTalk;
import org.pendant.controller.message.MessageLog;
import org.pendant.controller.world.ContactWorld;
import org.pendant.controller.world.MovedObject;
import org.pendant.controller.world.SightLine;
import org.pendant.controller.world.Vector3;
import org.pendant.models.pose.Pose;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/** Camera device: tells programs where parts are. */
final class CameraDevice implements CellDevice {
  private final DeviceSetup.Camera setup;
  private final MessageLog log;
  private final PartCamera camera;
  private final CameraProcedures procedures;
  private final ContactWorld world;
  private final Optional<SightLine> sight;

  CameraDevice(DeviceSetup.Camera setup, ContactWorld world, MessageLog log) {
    this.setup = setup;
    this.log = log;
    this.world = world;
    camera =
        new PartCamera(
            world::moved,
            new PartCamera.View(this::inView, this::clear),
            setup.atInBase().map(world::inBase),
            setup.errors());
    sight = setup.occlusion() ? world.sight() : Optional.empty();
    procedures = new CameraProcedures(camera);
  }

  private boolean inView(MovedObject each) {
    Pose middle = world.inCell(each.poseInBase());
    return setup.area().holds(middle.x(), middle.y(), middle.z())
        && (setup.objects().isEmpty()
            || setup.objects().stream().anyMatch(name -> PartCamera.goesBy(each, name)));
  }

  private boolean clear(MovedObject each) {
    return sight.isEmpty()
        || sight
            .get()
            .clear(
                place(setup.atInBase().orElseThrow()),
                place(world.inCell(each.poseInBase())),
                each.name());
  }

  private static Vector3 place(Pose pose) {
    return new Vector3(pose.x(), pose.y(), pose.z());
  }

  @Override
  public String name() {
    return setup.name();
  }

  @Override
  public String kind() {
    return text("camera");
  }

  @Override
  public boolean on() {
    return camera.sees();
  }

  @Override
  public String described() {
    return text("cameraAt", setup.ports().lines(), setup.ports().procedures());
  }

  @Override
  public OptionalInt port() {
    return OptionalInt.of(setup.ports().lines());
  }

  @Override
  public DeviceTalk connect() {
    return new CameraLines(name(), camera, log::warnOnce);
  }

  @Override
  public OptionalInt procedurePort() {
    return OptionalInt.of(setup.ports().procedures());
  }

  @Override
  public Optional<Value> call(String method, List<Value> arguments) throws ScriptError {
    return procedures.call(method, arguments);
  }

  @Override
  public boolean putPart(double widthM) {
    return false;
  }

  @Override
  public void step() {
    // it looks when it is asked
  }
}
