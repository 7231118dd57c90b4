package org.pendant.sweep.plan;

import java.util.OptionalInt;

/** Parameter target: what a parameter of a plan changes. */
public sealed interface ParameterTarget {

  /** Whether its values are whole numbers. */
  default boolean whole() {
    return false;
  }

  /** Whether its values are numbers; otherwise they may be any text. */
  default boolean numeric() {
    return true;
  }

  /**
   * The value that a variable of the script gets where it is assigned first, or where it is the
   * default of a function's parameter.
   *
   * @param element which element of the list or pose; empty for all of it
   */
  record Variable(String name, OptionalInt element) implements ParameterTarget {
    @Override
    public boolean numeric() {
      return false;
    }
  }

  /**
   * An argument of the function that is called first in a line.
   *
   * @param line of the script, from 1
   * @param argument name of the parameter
   */
  record CallArgument(int line, String argument) implements ParameterTarget {
    @Override
    public boolean numeric() {
      return false;
    }
  }

  /**
   * A factor on an argument of all moves of the program.
   *
   * @param argument v or a
   */
  record MoveFactor(String argument) implements ParameterTarget {}

  /** The speed slider, 0 to 1. */
  record Slider() implements ParameterTarget {}

  /**
   * What truly hangs on the flange, whatever the program declares.
   *
   * @param component 0 its mass, kg; 1 to 3 its centre of gravity in the flange frame, m
   */
  record Load(int component) implements ParameterTarget {}

  /** Where the base of the robot stands in the cell, beside where it stands now. */
  record BasePlace(FrameAxis axis) implements ParameterTarget {}

  /** Where a feature of the installation is, beside where it is now. */
  record FeaturePlace(String name, FrameAxis axis) implements ParameterTarget {}

  /** Where an object of the scene is, beside where it is now. */
  record ObjectPlace(String name, FrameAxis axis) implements ParameterTarget {}

  /** What an input has from the start. */
  record InputLevel(String signal) implements ParameterTarget {
    @Override
    public boolean numeric() {
      return false;
    }
  }

  /** When a digital input becomes high, s after the start of the program. */
  record InputTime(String signal) implements ParameterTarget {}

  /** The seed of random numbers and of the noise of sensors. */
  record Seed() implements ParameterTarget {
    @Override
    public boolean whole() {
      return true;
    }
  }

  /** Which arm it is. */
  record RobotModel() implements ParameterTarget {
    @Override
    public boolean numeric() {
      return false;
    }
  }
}
