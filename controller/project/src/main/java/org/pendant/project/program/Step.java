package org.pendant.project.program;

/**
 * Step: what one node of a program is, without its children; immutable. All lengths are in m,
 * angles in rad, forces in N, times in s.
 *
 * <p>Texts that are expressions hold URScript as it was typed. An empty text, name or list stands
 * for what has not been filled in yet: a tree may be unfinished at any time, and is checked as a
 * whole before it runs.
 */
public sealed interface Step
    permits Section, MotionStep, ActionStep, FlowStep, TemplateStep, ForeignStep {}
