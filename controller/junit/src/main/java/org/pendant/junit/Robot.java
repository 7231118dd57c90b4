package org.pendant.junit;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.junit.jupiter.api.extension.ExtendWith;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.box.ArmChoice;

/**
 * Robot for tests: gives parameters of type {@link RobotUnderTest} of a test class or method a
 * robot each, switched on for that test alone. At a parameter it says which robot that one is.
 */
@Documented
@Target({ElementType.TYPE, ElementType.METHOD, ElementType.PARAMETER})
@Retention(RetentionPolicy.RUNTIME)
@ExtendWith(RobotExtension.class)
public @interface Robot {
  /** Which arm, by its id. */
  String model() default ControllerOptions.DEFAULT_ROBOT;

  /** Which simulation of it. */
  ArmChoice arm() default ArmChoice.DYNAMIC;

  /** Seed of the random numbers of programs. */
  long seed() default 0;
}
