package org.pendant.controller.builtin;

import org.pendant.controller.box.ControlBox;
import org.pendant.script.function.Builtins;

/** Catalogue of every function and method that the controller knows. */
public final class StandardBuiltins {
  private StandardBuiltins() {}

  /** A new catalogue with all topics. */
  public static Builtins<ControlBox> create() {
    Builtins<ControlBox> builtins = new Builtins<>();
    MathBuiltins.declareIn(builtins);
    VectorBuiltins.declareIn(builtins);
    PoseBuiltins.declareIn(builtins);
    MatrixBuiltins.declareIn(builtins);
    ListBuiltins.declareIn(builtins);
    ListMethods.declareIn(builtins);
    StructMethods.declareIn(builtins);
    StringBuiltins.declareIn(builtins);
    AssertBuiltins.declareIn(builtins);
    MotionBuiltins.declareIn(builtins);
    ServoBuiltins.declareIn(builtins);
    ProcessMoveBuiltins.declareIn(builtins);
    OptimoveBuiltins.declareIn(builtins);
    ToolWrenchBuiltins.declareIn(builtins);
    MotionSettingBuiltins.declareIn(builtins);
    FreedriveBuiltins.declareIn(builtins);
    ToolpathBuiltins.declareIn(builtins);
    EncoderBuiltins.declareIn(builtins);
    ConveyorBuiltins.declareIn(builtins);
    PathOffsetBuiltins.declareIn(builtins);
    ForceBuiltins.declareIn(builtins);
    ContactBuiltins.declareIn(builtins);
    KinematicsBuiltins.declareIn(builtins);
    StateBuiltins.declareIn(builtins);
    DynamicsBuiltins.declareIn(builtins);
    PayloadBuiltins.declareIn(builtins);
    MountingBuiltins.declareIn(builtins);
    SensorBuiltins.declareIn(builtins);
    SafetyBuiltins.declareIn(builtins);
    BaseLightBuiltins.declareIn(builtins);
    TimeBuiltins.declareIn(builtins);
    LogBuiltins.declareIn(builtins);
    OperatorBuiltins.declareIn(builtins);
    IoBuiltins.declareIn(builtins);
    AnalogBuiltins.declareIn(builtins);
    RegisterBuiltins.declareIn(builtins);
    PortBuiltins.declareIn(builtins);
    PublishedBuiltins.declareIn(builtins);
    ToolIoBuiltins.declareIn(builtins);
    ToolSerialBuiltins.declareIn(builtins);
    InputActionBuiltins.declareIn(builtins);
    RunStateBuiltins.declareIn(builtins);
    SocketBuiltins.declareIn(builtins);
    SocketReadBuiltins.declareIn(builtins);
    RpcBuiltins.declareIn(builtins);
    ModbusSignalBuiltins.declareIn(builtins);
    ModbusOutputBuiltins.declareIn(builtins);
    RtdeInputBuiltins.declareIn(builtins);
    AssemblyBuiltins.declareIn(builtins);
    InterpreterBuiltins.declareIn(builtins);
    return builtins;
  }
}
