/**
 * The variables of a running program for those who look on: all of them at a low rate, and chosen
 * numbers in every frame. Open {@link org.pendant.controller.variables.VariableSamples} first.
 */
package org.pendant.controller.variables;
