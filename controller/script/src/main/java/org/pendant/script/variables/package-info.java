/**
 * Variables of a running program for its observers: all of them at a low rate, and chosen numbers
 * in every frame. Open {@link org.pendant.script.variables.VariableSamples} first.
 */
package org.pendant.script.variables;
