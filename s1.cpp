#include "app/case/case_file.h"
#include "libdda/analysis/run.h"
#include "libdda/errors.h"
#include <map>
#include <set>
#include <cstdio>
using namespace voussoir;
int main(int c,char**v){
  Case k=read_case(v[1],{});
  State st=initial_state(k.model); RunObserver o; int n=0; int from=atoi(v[2]);
  std::map<std::array<int,4>,std::vector<std::array<double,6>>> last;
  o.step=[&](const State&s,const StepReport&r,const RunReport&){ ++n;
    std::map<std::array<int,4>,std::vector<std::array<double,6>>> now;
    for(auto&p:s.contacts.patches){ std::array<int,4> key{p.block_a,p.block_b,p.part_a,p.part_b}; double area=0; for(int i=p.first_point;i<p.first_point+p.point_count;++i) area+=s.contacts.points[i].area; now[key].push_back({(double)p.point_count,area,p.normal.x(),p.normal.y(),p.normal.z(),0}); }
    if(n>from&&n<from+6){ printf("step %d patches %zu unbalanced %g changed %d\n",n,s.contacts.patches.size(),r.unbalanced,(int)r.contact_state_changed);
      for(auto&[key,a]:now){ auto it=last.find(key); if(it==last.end()) printf("   new %s %s parts %d %d: points %g area %g\n",k.model.blocks[key[0]].name.c_str(),k.model.blocks[key[1]].name.c_str(),key[2],key[3],a[0][0],a[0][1]); else if(a[0][0]!=it->second[0][0]||std::abs(a[0][1]-it->second[0][1])>1e-3*a[0][1]) printf("   change %s %s %d %d: points %g->%g area %g->%g n %g %g %g -> %g %g %g\n",k.model.blocks[key[0]].name.c_str(),k.model.blocks[key[1]].name.c_str(),key[2],key[3],it->second[0][0],a[0][0],it->second[0][1],a[0][1],it->second[0][2],it->second[0][3],it->second[0][4],a[0][2],a[0][3],a[0][4]); }
      for(auto&[key,a]:last) if(!now.count(key)) printf("   gone %s %s parts %d %d: points %g area %g\n",k.model.blocks[key[0]].name.c_str(),k.model.blocks[key[1]].name.c_str(),key[2],key[3],a[0][0],a[0][1]);
    }
    last=now; };
  o.stop=[&]{return n>from+6;};
  run(k.model,k.stages,st,o);
}
