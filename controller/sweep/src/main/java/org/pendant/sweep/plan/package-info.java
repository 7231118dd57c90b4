/**
 * Plans: what a sweep runs, with which values. Open {@link org.pendant.sweep.plan.PlanReader}
 * first: it reads a {@link org.pendant.sweep.plan.SweepPlan}, whose variants follow from their
 * numbers.
 */
package org.pendant.sweep.plan;
