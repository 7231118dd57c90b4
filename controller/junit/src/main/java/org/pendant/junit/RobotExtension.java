package org.pendant.junit;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.extension.AfterTestExecutionCallback;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.extension.ExtensionContext.Namespace;
import org.junit.jupiter.api.extension.ParameterContext;
import org.junit.jupiter.api.extension.ParameterResolver;
import org.pendant.controller.ControllerOptions;

/** JUnit extension behind {@link Robot}; a red test reports the log of its robots. */
public final class RobotExtension implements ParameterResolver, AfterTestExecutionCallback {
  private static final Namespace NAMESPACE = Namespace.create(RobotExtension.class);
  private static final String ROBOTS = "robots";

  /** The robots of one test. */
  private static final class Robots {
    private final List<RobotUnderTest> all = new ArrayList<>();
  }

  @Override
  public boolean supportsParameter(ParameterContext parameter, ExtensionContext test) {
    return parameter.getParameter().getType() == RobotUnderTest.class;
  }

  @Override
  public Object resolveParameter(ParameterContext parameter, ExtensionContext test) {
    RobotUnderTest robot = new RobotUnderTest(options(parameter, test));
    robots(test).all.add(robot);
    return robot;
  }

  private static Robots robots(ExtensionContext test) {
    return test.getStore(NAMESPACE).getOrComputeIfAbsent(ROBOTS, _ -> new Robots(), Robots.class);
  }

  private static ControllerOptions options(ParameterContext parameter, ExtensionContext test) {
    Optional<Robot> wanted =
        parameter
            .findAnnotation(Robot.class)
            .or(() -> test.getTestMethod().map(each -> each.getAnnotation(Robot.class)))
            .or(() -> test.getTestClass().map(each -> each.getAnnotation(Robot.class)));
    ControllerOptions options = ControllerOptions.headless();
    return wanted
        .map(each -> options.withRobot(each.model()).withArm(each.arm()).withSeed(each.seed()))
        .orElse(options);
  }

  @Override
  public void afterTestExecution(ExtensionContext test) {
    if (test.getExecutionException().isPresent()) {
      for (RobotUnderTest each : robots(test).all) {
        test.publishReportEntry("robot", each.summary());
      }
    }
  }
}
